#include "io/mesh.h"

#include "io/error.h"
#include "io/file_text.h"

#include <algorithm>
#include <cstring>

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
  char* at = file.begin();
  while ((at = static_cast<char*>(std::memchr(at, '\r', size_t(file.end() - at))))) {
    if (at + 1 == file.end() || at[1] != '\n') *at = '\n';
    if (++at == file.end()) break;
  }
}

/// A PLY file whose header ends its lines with carriage returns alone and is followed by text.
bool is_old_text(std::string_view ply) {
  if (ply.find('\n') != std::string_view::npos) return false;
  const size_t format = ply.find("\rformat "), end = ply.find("\rend_header");
  return format < end && ply.substr(format + 8).starts_with("ascii");
}

}  // namespace

uint64_t largest_mesh_memory() { return 2 * largest_mesh_file(); }

Mesh read_mesh(const std::string& path, uint64_t most_bytes) {
  FileText file = read_file(path, std::min(largest_mesh_file(), most_bytes));
  if (file.view().empty()) {
    throw InputError(path + ": is empty (a mesh has vertices) give an OBJ or PLY file");
  }
  if (is_ply(file.view()) || is_named_ply(path)) {
    if (is_old_text(file.view())) mend_line_ends(file);
    return read_ply(file.view(), path, most_bytes);
  }
  mend_line_ends(file);
  return read_obj(file.view(), path, most_bytes);
}

}  // namespace weft::io
