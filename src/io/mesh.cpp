#include "io/mesh.h"

#include "io/error.h"
#include "io/file_text.h"

#include <cstring>

namespace weft::io {
namespace {

bool is_ply(std::string_view text) {
  return text.substr(0, 3) == "ply" && text.size() > 4 && (text[3] == '\n' || text[3] == '\r');
}

bool is_named_ply(const std::string& path) {
  return path.size() >= 4 && (path.ends_with(".ply") || path.ends_with(".PLY"));
}

bool is_binary(std::string_view text) {
  if (!is_ply(text)) return false;
  const size_t format = text.find(text[3] == '\r' && text[4] != '\n' ? "\rformat " : "\nformat ");
  return format == std::string_view::npos || !text.substr(format + 8).starts_with("ascii");
}

// Old programs end a line with a carriage return alone.
void mend_line_ends(FileText& file) {
  if (is_binary(file.view())) return;
  char* at = file.begin();
  while ((at = static_cast<char*>(std::memchr(at, '\r', size_t(file.end() - at))))) {
    if (at + 1 == file.end() || at[1] != '\n') *at = '\n';
    if (++at == file.end()) break;
  }
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
