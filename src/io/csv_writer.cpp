#include "io/csv_writer.h"

#include <charconv>

namespace weft::io {
namespace {

template <class... Format>
void append(std::string& line, Format... number) {
  char text[32];
  line.append(text, std::to_chars(text, text + sizeof text, number...).ptr);
}

}  // namespace

FinalWriter::FinalWriter(const std::string& path) : file_(path, Sync::yes) {
  file_.write("cloth,vertex,x,y,z,vx,vy,vz\n");
}

void FinalWriter::add_cloth(size_t cloth, std::span<const double3> positions,
                            std::span<const double3> velocities) {
  std::string line;
  for (size_t vertex = 0; vertex < positions.size(); ++vertex) {
    line.clear();
    append(line, cloth);
    line += ',';
    append(line, vertex);
    const double3 x = positions[vertex], v = velocities[vertex];
    for (const double value : {x.x, x.y, x.z, v.x, v.y, v.z}) {
      line += ',';
      // With a precision, to_chars is printf's %.17g in the "C" locale.
      append(line, value, std::chars_format::general, 17);
    }
    line += '\n';
    file_.write(line);
  }
}

}  // namespace weft::io
