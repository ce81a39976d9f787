// PLY, text and binary: elements `vertex` (x, y, z), `face` (vertex_indices) and `edge` (vertex1,
// vertex2); all else is skipped.
#include "io/mesh.h"

#include "io/error.h"
#include "io/face_list.h"
#include "io/ply_body.h"

namespace weft::io {
namespace {

template <class Body>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Body body, std::string_view text, const std::string& name,
            uint64_t most_bytes)
      : header_(header),
        body_(std::move(body)),
        text_(text),
        name_(name),
        most_bytes_(most_bytes),
        memory_(most_bytes, text.size()) {}
  PlyReader(const PlyReader&) = delete;

  Mesh read() {
    for (const PlyElement& element : header_.elements) {
      element_ = &element;
      check_size(element.least_bytes(header_.format));
      if (element.name == "vertex")
        read_vertices();
      else if (element.name == "face")
        read_faces();
      else if (element.name == "edge" && has_ends(element))
        read_edges();
      else
        skip_element();
    }
    require_cut(faces_.finish());
    if (const uint64_t left = body_.spare_bytes()) {
      mesh_.warnings.push_back(std::to_string(left) +
                               " bytes behind the last element were skipped (the header does not "
                               "declare them)");
    }
    return std::move(mesh_);
  }

 private:
  // A message that names the element, and in text files the line.
  [[noreturn]] void fail(const std::string& problem) const {
    std::string where = name_ + ": ";
    if (header_.format == PlyFormat::ascii) {
      const auto offset = size_t(body_.position() ? body_.position() - text_.data() : 0);
      where += "line " + std::to_string(line_number(text_, offset)) + ": ";
    }
    throw InputError(where + shown(element_->name) + " " + std::to_string(record_) + ": " +
                     problem);
  }
  void require_room(bool there_is) const {
    if (there_is) return;
    fail("the mesh does not fit from here on (reading may take " + std::to_string(most_bytes_) +
         " bytes on this machine) give a smaller file");
  }
  void require(bool done, const PlyProperty& property) const {
    if (!done) fail(shown(property.name) + ": " + body_.fault());
  }

  // Headers promise anything; the body cannot be shorter than its records.
  void check_size(uint64_t least) const {
    if (least == 0 || element_->count <= body_.bytes_left() / least) return;
    throw InputError(name_ + ": element " + shown(element_->name) + " " +
                     std::to_string(element_->count) + " does not fit in the " +
                     std::to_string(body_.bytes_left()) + " bytes left (each takes at least " +
                     std::to_string(least) +
                     "; a text-mode copy drops bytes of a binary file) give the whole file");
  }

  void read_vertices() {
    const PlyElement& element = *element_;
    const size_t axes[3] = {element.find("x"), element.find("y"), element.find("z")};
    for (size_t axis = 0; axis < 3; ++axis) {
      if (axes[axis] == element.properties.size() || element.properties[axes[axis]].is_list) {
        throw InputError(name_ + ": element vertex has no number property '" + "xyz"[axis] +
                         "' (positions need three) add it");
      }
    }
    record_ = 0;
    require_room(memory_.make_room(mesh_.positions, element.count));
    for (record_ = 0; record_ < element.count; ++record_) {
      begin();
      double values[3] = {};
      for (size_t p = 0; p < element.properties.size(); ++p) {
        const size_t axis = p == axes[0] ? 0 : p == axes[1] ? 1 : p == axes[2] ? 2 : 3;
        if (axis < 3)
          read_coordinate(element.properties[p], values[axis]);
        else
          skip_property(element.properties[p]);
      }
      end();
      mesh_.positions.push_back({values[0], values[1], values[2]});
    }
  }

  void read_coordinate(const PlyProperty& property, double& value) {
    require(body_.next_real(property.type, value), property);
    if (!std::isfinite(value)) {
      fail(shown(property.name) + ": " + number_text(value) + " " +
           to_text(NumberFault::not_finite));
    }
  }

  void read_faces() {
    const PlyElement& element = *element_;
    size_t indices = element.find("vertex_indices");
    if (indices == element.properties.size()) indices = element.find("vertex_index");
    const bool found = indices < element.properties.size() && element.properties[indices].is_list &&
                       is_integer(element.properties[indices].type);
    if (!found && element.count > 0) {
      throw InputError(name_ +
                       ": element face has no list of integers 'vertex_indices' (nor "
                       "'vertex_index'; a face is its vertices) add it");
    }
    if (found) {
      const bool text = header_.format == PlyFormat::ascii;
      const size_t corner = text ? 2 : size_of(element.properties[indices].type);
      check_size(element.least_bytes(header_.format) + 3 * corner);
    }
    record_ = 0;
    require_room(memory_.make_room(mesh_.triangles, 3 * element.count));
    for (record_ = 0; record_ < element.count; ++record_) {
      begin();
      for (size_t p = 0; p < element.properties.size(); ++p) {
        if (p == indices)
          read_polygon(element.properties[p]);
        else
          skip_property(element.properties[p]);
      }
      end();
    }
  }

  void read_polygon(const PlyProperty& property) {
    const uint64_t corners = read_count(property);
    if (corners < 3) {
      fail("the face has " + std::to_string(corners) +
           " vertices (a face needs at least three) correct or remove it");
    }
    if (corners > 3 && corners > vertex_count()) {
      fail("the face has " + std::to_string(corners) + " vertices (the file has " +
           std::to_string(vertex_count()) + ", so that it names one twice) correct it");
    }
    polygon_.clear();
    require_room(memory_.make_room(polygon_, corners));
    for (uint64_t k = 0; k < corners; ++k) {
      int64_t index = 0;
      require(body_.next_integer(property.type, index), property);
      polygon_.push_back(checked_index(index));
    }
    if (corners > 3) {
      scratch_.clear();
      require_room(memory_.make_room(scratch_, corners));
      scratch_ = polygon_;
      if (const uint32_t* twice = repeated_vertex(scratch_)) {
        fail("the face names vertex " + std::to_string(*twice) +
             " twice (its triangles would overlap) remove one of the two");
      }
    }
    require_cut(faces_.add(polygon_, body_.position()));
  }

  void require_cut(Cut cut) {
    if (cut == Cut::done) return;
    require_room(cut != Cut::no_memory);
    const FaceList::Failure& failure = faces_.failure();
    std::string where = name_ + ": ";
    if (header_.format == PlyFormat::ascii) {
      where +=
          "line " + std::to_string(line_number(text_, size_t(failure.line - text_.data()))) + ": ";
    }
    throw InputError(where + "face " + std::to_string(failure.face) + ": the face " +
                     to_text(cut, failure.corners));
  }

  static bool has_ends(const PlyElement& element) {
    for (const char* end : {"vertex1", "vertex2"}) {
      const size_t at = element.find(end);
      if (at == element.properties.size() || element.properties[at].is_list ||
          !is_integer(element.properties[at].type)) {
        return false;
      }
    }
    return true;
  }

  void read_edges() {
    const PlyElement& element = *element_;
    const size_t ends[2] = {element.find("vertex1"), element.find("vertex2")};
    record_ = 0;
    require_room(memory_.make_room(mesh_.lines, element.count));
    for (record_ = 0; record_ < element.count; ++record_) {
      begin();
      uint32_t vertex[2] = {};
      for (size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (p != ends[0] && p != ends[1]) {
          skip_property(property);
          continue;
        }
        int64_t index = 0;
        require(body_.next_integer(property.type, index), property);
        vertex[p == ends[1]] = checked_index(index);
      }
      end();
      if (vertex[0] == vertex[1]) {
        fail("joins vertex " + std::to_string(vertex[0]) +
             " to itself (a spring has two ends) correct or remove it");
      }
      mesh_.lines.push_back({vertex[0], vertex[1]});
    }
  }

  uint64_t vertex_count() const {
    const PlyElement* vertices = header_.find("vertex");
    return vertices ? vertices->count : 0;
  }

  uint32_t checked_index(int64_t index) const {
    const uint64_t count = vertex_count();
    if (index < 0 || uint64_t(index) >= count || index > int64_t(UINT32_MAX)) {
      fail("vertex index " + std::to_string(index) + " is out of range (the file has " +
           std::to_string(count) + " vertices; indices start at 0) correct it");
    }
    return uint32_t(index);
  }

  uint64_t read_count(const PlyProperty& property) {
    int64_t count = 0;
    require(body_.next_integer(property.count_type, count), property);
    if (count < 0)
      fail(shown(property.name) + ": the list length " + std::to_string(count) +
           " is negative (it counts values) correct it");
    if (uint64_t(count) > body_.values_left(property.type)) {
      fail(shown(property.name) + ": the list length " + std::to_string(count) +
           " is more than what is left (the list is cut off) correct it");
    }
    return uint64_t(count);
  }

  void skip_property(const PlyProperty& property) {
    const uint64_t count = property.is_list ? read_count(property) : 1;
    require(body_.skip(property.type, count), property);
  }

  void skip_element() {
    const PlyElement& element = *element_;
    if (element.properties.empty()) return;
    for (record_ = 0; record_ < element.count; ++record_) {
      begin();
      for (const PlyProperty& property : element.properties) skip_property(property);
      end();
    }
  }

  void begin() {
    if (!body_.begin_record()) fail(body_.fault());
  }
  void end() {
    if (!body_.end_record()) fail(body_.fault());
  }

  const PlyHeader& header_;
  Body body_;
  std::string_view text_;
  const std::string& name_;
  uint64_t most_bytes_;
  MemoryLimit memory_;
  Mesh mesh_;
  const PlyElement* element_ = nullptr;
  uint64_t record_ = 0;
  FaceList faces_{mesh_, memory_};
  Polygon polygon_, scratch_;
};

}  // namespace

Mesh read_ply(std::string_view text, const std::string& name, uint64_t most_bytes) {
  const PlyHeader header = read_ply_header(text, name);
  const PlyElement* vertices = header.find("vertex");
  if (!vertices || vertices->count == 0) {
    throw InputError(name +
                     ": has no vertices (no element vertex with a count above 0) give a mesh");
  }
  const std::string_view body = text.substr(header.body);
  Mesh mesh = header.format == PlyFormat::ascii
                  ? PlyReader(header, PlyTextBody(body), text, name, most_bytes).read()
                  : PlyReader(header, PlyBinaryBody(body, header.format == PlyFormat::big_endian),
                              text, name, most_bytes)
                        .read();
  mesh.warnings.insert(mesh.warnings.begin(), header.warnings.begin(), header.warnings.end());
  return mesh;
}

}  // namespace weft::io
