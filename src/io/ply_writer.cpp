#include "io/surface.h"

#include "io/little_endian.h"
#include "io/output_file.h"

namespace weft::io {
namespace {

char* put(char* at, double3 values, Precision precision) {
  for (const double value : {values.x, values.y, values.z}) {
    at = precision == Precision::float32 ? put_little(at, static_cast<float>(value))
                                         : put_little(at, value);
  }
  return at;
}

std::string header(const Surface& surface, Precision precision, bool with_normals) {
  const std::string real = precision == Precision::float32 ? "float" : "double";
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  text += "element vertex " + std::to_string(surface.positions.size()) + "\n";
  for (const char* name : {"x", "y", "z"}) text += "property " + real + " " + name + "\n";
  if (with_normals) {
    for (const char* name : {"nx", "ny", "nz"}) text += "property " + real + " " + name + "\n";
  }
  text += "element face " + std::to_string(surface.triangles.size()) + "\n";
  text += "property list uchar int vertex_indices\n";
  if (!surface.edges.empty()) {
    text += "element edge " + std::to_string(surface.edges.size()) + "\n";
    text += "property int vertex1\nproperty int vertex2\n";
  }
  return text + "end_header\n";
}

}  // namespace

void write_ply(const std::string& path, const Surface& surface, Precision precision,
               bool with_normals) {
  with_normals = with_normals && !surface.normals.empty();
  OutputFile file(path);
  file.write(header(surface, precision, with_normals));
  char record[6 * sizeof(double)];
  for (size_t i = 0; i < surface.positions.size(); ++i) {
    char* at = put(record, surface.positions[i], precision);
    if (with_normals) at = put(at, surface.normals[i], precision);
    file.write(record, size_t(at - record));
  }
  for (const auto& triangle : surface.triangles) {
    char* at = put_little(record, uint8_t(3));
    for (const uint32_t v : triangle) at = put_little(at, v);
    file.write(record, size_t(at - record));
  }
  for (const auto& edge : surface.edges) {
    char* at = record;
    for (const uint32_t v : edge) at = put_little(at, v);
    file.write(record, size_t(at - record));
  }
  file.commit();
}

}  // namespace weft::io
