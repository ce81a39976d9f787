#include "render/yielding_mesh.h"

#include "render/subdivide.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

namespace weft::render {
namespace {

std::vector<Vector3d> places_of(const io::Mesh& mesh) {
  std::vector<Vector3d> places;
  for (const double3& p : mesh.positions) places.push_back(vector(p));
  return places;
}

double longest_edge(const io::Mesh& mesh) {
  Box box;
  for (const double3& p : mesh.positions) box.add(vector(p));
  return box.empty() ? 1 : box.radius() / 12;
}

}  // namespace

YieldingMesh::Shape::Shape(const io::MeshColliderScene& d)
    : mesh(subdivided(*d.mesh, longest_edge(*d.mesh))),
      ridges(mesh, d.scale, d.closed),
      drawn(with_creases(places_of(mesh), mesh.triangles)),
      model(drawn.triangles) {}

YieldingMesh::YieldingMesh(const io::MeshColliderScene& d, Shapes& shapes)
    : turn_(rotation(d.pose.axis, d.pose.degrees)),
      place_(vector(d.pose.translate)),
      velocity_(vector(d.velocity)),
      scale_(d.scale) {
  auto& shape = shapes[{d.mesh.get(), d.scale, d.closed}];
  if (!shape) shape = std::make_shared<const Shape>(d);
  shape_ = shape;
}

void YieldingMesh::update(const io::Surface& surface, double time) {
  const Vector3d here = place_ + velocity_ * time;
  std::vector<Vector3d> seen;
  seen.reserve(surface.positions.size());
  for (const double3& p : surface.positions) {
    seen.push_back(turn_.transpose() * (vector(p) - here));
  }
  Ridges::Depths depths = shape_->ridges.no_depths();
  for (const auto& t : surface.triangles) {
    shape_->ridges.add({seen[t[0]], seen[t[1]], seen[t[2]]}, depths);
  }
  const Ridges::Inset inset = shape_->ridges.inset(depths);
  shows_ = shows_ || !inset.enough;
  moved_.reset();
  if (inset.by.empty()) return;
  // The normals stay: what gives way is hardly seen, and shall not catch the eye.
  Triangles drawn = shape_->drawn.triangles;
  for (size_t i = 0; i < drawn.vertices.size(); ++i) {
    const uint32_t v = shape_->drawn.origins[i];
    const Vector3f p = (vector(shape_->mesh.positions[v]) - inset.by[v] / scale_).cast<float>();
    std::copy_n(p.data(), 3, drawn.vertices[i].begin());
  }
  moved_ = std::make_unique<Model>(drawn);
}

uint64_t bytes_of_meshes(const io::Scene& scene) {
  constexpr uint64_t per_piece = 2400;
  std::set<YieldingMesh::Key> known;
  uint64_t sum = 0;
  for (const io::ColliderScene& collider : scene.colliders) {
    const auto* d = std::get_if<io::MeshColliderScene>(&collider);
    if (!d || !known.insert({d->mesh.get(), d->scale, d->closed}).second) continue;
    sum += per_piece * most_pieces(*d->mesh, longest_edge(*d->mesh));
  }
  return sum;
}

void YieldingMesh::draw() const { (moved_ ? *moved_ : shape_->model).draw(); }

}  // namespace weft::render
