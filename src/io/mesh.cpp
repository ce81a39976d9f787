#include "io/mesh.h"

#include "io/error.h"
#include "io/file_text.h"

#include <algorithm>

namespace weft::io {
namespace {

bool is_ply(std::string_view text) {
  return text.substr(0, 3) == "ply" && text.size() > 3 && (text[3] == '\n' || text[3] == '\r');
}

bool is_named_ply(const std::string& path) {
  return path.size() >= 4 && (path.ends_with(".ply") || path.ends_with(".PLY"));
}

// Old programs end a line with a carriage return alone.
void mend_line_ends(FileText& file) {
  const std::string_view text = file.view();
  const bool binary = is_ply(text) && text.substr(0, 200).find("ascii") == std::string_view::npos;
  if (binary || text.find('\n') != std::string_view::npos) return;
  std::replace(file.begin(), file.end(), '\r', '\n');
}

}  // namespace

uint64_t largest_mesh_memory() { return 2 * largest_mesh_file(); }

Mesh read_mesh(const std::string& path) {
  FileText file = read_file(path, largest_mesh_file());
  if (file.view().empty()) {
    throw InputError(path + ": is empty (a mesh has vertices) give an OBJ or PLY file");
  }
  mend_line_ends(file);
  if (is_ply(file.view()) || is_named_ply(path)) return read_ply(file.view(), path);
  return read_obj(file.view(), path);
}

}  // namespace weft::io
