// The faces of a file on their way to triangles, shared by the readers.
#pragma once

#include "io/mesh.h"
#include "io/polygon.h"

namespace weft::io {

/// Takes polygons in the order of the file. One whose vertices are all known is cut at once; the
/// others wait for the end of the file.
class FaceList {
 public:
  FaceList(Mesh& mesh, MemoryLimit& memory) : mesh_(mesh), memory_(memory), cutter_(memory) {}

  /// A face that could not be cut.
  struct Failure {
    Cut cut;
    uint32_t face;  ///< number in the file, from 0
    size_t corners;
    const char* line;  ///< where the file says so
  };

  /// Of at least three vertices. Afterwards `failure()` says whether there was one.
  Cut add(const Polygon& polygon, const char* line) {
    const size_t first = mesh_.triangles.size();
    if (!append_fan(polygon, mesh_.triangles, memory_) || !number(polygon.size())) {
      return fail(Cut::no_memory, faces_, polygon.size(), line);
    }
    const uint32_t face = faces_++;
    if (polygon.size() == 3) return Cut::done;
    for (const uint32_t v : polygon) {
      if (v < mesh_.positions.size()) continue;
      if (!memory_.make_room(waiting_, 1)) return fail(Cut::no_memory, face, 0, line);
      waiting_.push_back({first, polygon.size(), face, line});
      return Cut::done;
    }
    return fail(cutter_.cut(mesh_.positions, polygon, &mesh_.triangles[first]), face,
                polygon.size(), line);
  }

  /// Cuts those that waited, all of whose vertices are known now.
  Cut finish() {
    Polygon polygon;
    for (const Waiting& w : waiting_) {
      polygon.clear();
      if (!memory_.make_room(polygon, w.corners)) return fail(Cut::no_memory, w.face, 0, w.line);
      read_fan(&mesh_.triangles[w.first], w.corners, polygon);
      const Cut cut = cutter_.cut(mesh_.positions, polygon, &mesh_.triangles[w.first]);
      if (cut != Cut::done) return fail(cut, w.face, w.corners, w.line);
    }
    return Cut::done;
  }

  const Failure& failure() const { return failure_; }
  uint32_t count() const { return faces_; }

 private:
  struct Waiting {
    size_t first, corners;
    uint32_t face;
    const char* line;
  };

  Cut fail(Cut cut, uint32_t face, size_t corners, const char* line) {
    failure_ = {cut, face, corners, line};
    return cut;
  }

  /// Notes the face of its triangles, once there are polygons.
  bool number(size_t corners) {
    std::vector<uint32_t>& faces = mesh_.faces;
    if (faces.empty() && corners > 3) {
      if (!memory_.make_room(faces, mesh_.triangles.size() / 3)) return false;
      for (uint32_t f = 0; f < faces_; ++f) faces.push_back(f);
    } else if (faces.empty()) {
      return true;
    }
    if (!memory_.make_room(faces, corners - 2)) return false;
    faces.insert(faces.end(), corners - 2, faces_);
    return true;
  }

  Mesh& mesh_;
  MemoryLimit& memory_;
  PolygonCutter cutter_;
  std::vector<Waiting> waiting_;
  Failure failure_{Cut::done, 0, 0, nullptr};
  uint32_t faces_ = 0;
};

}  // namespace weft::io
