#include "render/yielding_mesh.h"

#include "render/creases.h"

#include <Eigen/Geometry>

namespace weft::render {
namespace {

std::vector<Vector3d> places_of(const io::Mesh& mesh) {
  std::vector<Vector3d> places;
  for (const double3& p : mesh.positions) places.push_back(vector(p));
  return places;
}

}  // namespace

YieldingMesh::Shape::Shape(const io::MeshColliderScene& d)
    : mesh(d.mesh),
      ridges(*mesh, d.scale, d.closed),
      model(with_creases(places_of(*mesh), mesh->triangles)) {}

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
  const Vector3d place = place_ + velocity_ * time;
  std::vector<Vector3d> seen;
  seen.reserve(surface.positions.size());
  for (const double3& p : surface.positions) {
    seen.push_back(turn_.transpose() * (vector(p) - place));
  }
  Ridges::Depths depths = shape_->ridges.no_depths();
  for (const auto& t : surface.triangles) {
    shape_->ridges.add({seen[t[0]], seen[t[1]], seen[t[2]]}, depths);
  }
  const Ridges::Inset inset = shape_->ridges.inset(depths);
  shows_ = shows_ || !inset.enough;
  moved_.reset();
  if (inset.by.empty()) return;
  std::vector<Vector3d> places = places_of(*shape_->mesh);
  for (size_t v = 0; v < places.size(); ++v) places[v] -= inset.by[v] / scale_;
  moved_ = std::make_unique<Model>(with_creases(places, shape_->mesh->triangles));
}

void YieldingMesh::draw() const { (moved_ ? *moved_ : shape_->model).draw(); }

}  // namespace weft::render
