#include "io/surface.h"

#include "io/output_file.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace weft::io {
namespace {

class LineWriter {
 public:
  explicit LineWriter(OutputFile& file) : file_(file) {}

  void begin(std::string_view keyword) { end_ = std::copy(keyword.begin(), keyword.end(), text_); }
  template <class Number>
  void add(Number value) {
    *end_++ = ' ';
    end_ = std::to_chars(end_, text_ + sizeof text_, value).ptr;
  }
  void add(double3 values, Precision precision) {
    for (const double value : {values.x, values.y, values.z}) {
      if (precision == Precision::float32)
        add(static_cast<float>(value));
      else
        add(value);
    }
  }
  /// Position and normal of the same number: "7//7".
  void add_with_normal(uint32_t vertex) {
    add(vertex);
    *end_++ = '/';
    *end_++ = '/';
    end_ = std::to_chars(end_, text_ + sizeof text_, vertex).ptr;
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

// A name stands on one line, which a backslash at its end would continue.
std::string one_line(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\\') c = '_';
  }
  return name;
}

void write_points(LineWriter& line, std::string_view keyword, const std::vector<double3>& points,
                  const SurfacePart& part, Precision precision) {
  for (size_t i = 0; i < part.vertex_count; ++i) {
    line.begin(keyword);
    line.add(points[part.first_vertex + i], precision);
    line.end();
  }
}

void write_faces(LineWriter& line, const Surface& surface, const SurfacePart& part,
                 bool with_normals) {
  for (size_t i = 0; i < part.triangle_count; ++i) {
    line.begin("f");
    for (const uint32_t v : surface.triangles[part.first_triangle + i]) {
      if (with_normals)
        line.add_with_normal(v + 1);
      else
        line.add(v + 1);
    }
    line.end();
  }
}

void write_lines(LineWriter& line, const Surface& surface, const SurfacePart& part) {
  for (size_t i = 0; i < part.edge_count; ++i) {
    line.begin("l");
    for (const uint32_t v : surface.edges[part.first_edge + i]) line.add(v + 1);
    line.end();
  }
}

}  // namespace

void write_obj(const std::string& path, const Surface& surface, Precision precision,
               bool with_normals) {
  with_normals = with_normals && !surface.normals.empty();
  OutputFile file(path);
  LineWriter line(file);
  for (const SurfacePart& part : surface.parts) {
    file.write("o " + one_line(part.name) + "\n");
    write_points(line, "v", surface.positions, part, precision);
    if (with_normals) write_points(line, "vn", surface.normals, part, precision);
    write_faces(line, surface, part, with_normals);
    write_lines(line, surface, part);
  }
  file.commit();
}

}  // namespace weft::io
