#include "io/surface.h"

#include "io/output_file.h"

#include <charconv>

namespace weft::io {
namespace {

class LineWriter {
 public:
  explicit LineWriter(OutputFile& file) : file_(file) {}

  void begin(char keyword) {
    end_ = text_;
    *end_++ = keyword;
  }
  template <class Number>
  void add(Number value) {
    *end_++ = ' ';
    end_ = std::to_chars(end_, text_ + sizeof text_, value).ptr;
  }
  void add_rounded(double value, Precision precision) {
    if (precision == Precision::float32)
      add(static_cast<float>(value));
    else
      add(value);
  }
  void end() {
    *end_++ = '\n';
    file_.write(text_, size_t(end_ - text_));
  }

 private:
  OutputFile& file_;
  char text_[128] = {};
  char* end_ = text_;
};

// A name stands on one line.
std::string one_line(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < ' ') c = '_';
  }
  return name;
}

}  // namespace

void write_obj(const std::string& path, const Surface& surface, Precision precision) {
  OutputFile file(path);
  LineWriter line(file);
  for (const SurfacePart& part : surface.parts) {
    file.write("o " + one_line(part.name) + "\n");
    for (size_t i = 0; i < part.vertex_count; ++i) {
      const double3 p = surface.positions[part.first_vertex + i];
      line.begin('v');
      for (const double c : {p.x, p.y, p.z}) line.add_rounded(c, precision);
      line.end();
    }
    for (size_t i = 0; i < part.triangle_count; ++i) {
      line.begin('f');
      for (const uint32_t v : surface.triangles[part.first_triangle + i]) line.add(v + 1);
      line.end();
    }
    for (size_t i = 0; i < part.edge_count; ++i) {
      line.begin('l');
      for (const uint32_t v : surface.edges[part.first_edge + i]) line.add(v + 1);
      line.end();
    }
  }
  file.commit();
}

}  // namespace weft::io
