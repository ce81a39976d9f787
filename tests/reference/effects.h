// What several tests of colliders, wind and normals share: a frame that no axis favours, triangles
// as collider and as cloth, and one collider of each shape.
#pragma once

#include "reference/mesh_shapes.h"
#include "reference/networks.h"

namespace weft_tests {

using reference::Triangles;

/// Orthonormal.
constexpr Vec ahead{2. / 7, 3. / 7, 6. / 7}, across{6. / 7, 2. / 7, -3. / 7},
    beside{3. / 7, -6. / 7, 2. / 7};

/// `v` turned by `degrees` about `axis` (Rodrigues).
inline Vec turned(Vec v, Vec axis, double degrees) {
  const Vec n = (1 / length(axis)) * axis;
  const double angle = degrees * 3.14159265358979323846 / 180;
  return std::cos(angle) * v + std::sin(angle) * cross(n, v) +
         (1 - std::cos(angle)) * dot(n, v) * n;
}

inline weft::View<uint32_t> indices_of(const Triangles& mesh) {
  return {mesh.faces.empty() ? nullptr : mesh.faces[0].data(), 3 * mesh.faces.size()};
}

inline weft::ColliderMesh cook_collider(TestWorld& test, const Triangles& mesh, double thickness,
                                        bool closed) {
  const std::vector<weft::double3> positions = to_weft(mesh.vertices);
  weft::ColliderMeshDesc desc;
  desc.positions = weft::View<weft::double3>(positions);
  desc.indices = indices_of(mesh);
  desc.thickness = thickness;
  desc.closed = closed;
  return test.take(test.context().cook(desc));
}

inline weft::ColliderId add_collider(TestWorld& test, const Triangles& mesh, double thickness,
                                     bool closed, weft::MeshColliderDesc desc = {}) {
  desc.mesh = cook_collider(test, mesh, thickness, closed);
  return test.take(test.world().create_mesh(desc));
}

/// Two triangles between +-half in x and z at y = 0, looking up.
inline Triangles square(double half) {
  Triangles mesh;
  mesh.vertices = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
  mesh.faces = {{0, 2, 1}, {0, 3, 2}};
  return mesh;
}

/// The triangles of a fabric whose vertices are at `at`.
inline Triangles triangles_of(const weft::Fabric& fabric, std::vector<Vec> at) {
  Triangles mesh;
  mesh.vertices = std::move(at);
  mesh.faces.resize(fabric.triangle_count());
  if (!mesh.faces.empty()) {
    const weft::Status status =
        fabric.read_triangles(0, fabric.triangle_count(), mesh.faces[0].data());
    EXPECT_EQ(status, weft::Status::ok);
  }
  return mesh;
}

/// Triangles as cloth: without springs' forces unless `material` says otherwise.
inline weft::ClothId add_mesh_cloth(TestWorld& test, const Triangles& mesh, weft::Material material,
                                    weft::ClothDesc cloth = {}) {
  const std::vector<weft::double3> positions = to_weft(mesh.vertices);
  weft::MeshDesc desc;
  desc.positions = weft::View<weft::double3>(positions);
  desc.indices = indices_of(mesh);
  desc.material = material;
  return test.add(desc, cloth);
}

inline weft::Material slack(weft::Mass::Kind kind, double mass) {
  weft::Material material;
  material.stiffness = 0;
  material.mass.kind = kind;
  material.mass.value = mass;
  return material;
}

/// Every shape that a collider can have.
enum class Body { sphere, plane, capsule, cylinder, box, mesh };
constexpr Body every_body[] = {Body::sphere,   Body::plane, Body::capsule,
                               Body::cylinder, Body::box,   Body::mesh};
inline const char* name(Body body) {
  const char* const names[] = {"sphere", "plane", "capsule", "cylinder", "box", "mesh"};
  return names[int(body)];
}

/// One whose highest point is `top` and whose inside reaches `size` in every direction from
/// top - size. The mesh is a closed cube with a thickness of a tenth of `size`.
inline weft::ColliderId add_body(TestWorld& test, Body body, Vec top, double size,
                                 double friction = 0, Vec velocity = {}, uint32_t layers = ~0u) {
  const Vec centre = top - Vec{0, size, 0};
  weft::World& world = test.world();
  const auto with = [&](auto desc) {
    desc.friction = friction;
    desc.velocity = to_weft(velocity);
    desc.layers = layers;
    return desc;
  };
  switch (body) {
    case Body::sphere: {
      weft::SphereDesc desc;
      desc.center = to_weft(centre);
      desc.radius = size;
      return test.take(world.create_sphere(with(desc)));
    }
    case Body::plane: {
      weft::PlaneDesc desc;
      desc.offset = top.y;
      return test.take(world.create_plane(with(desc)));
    }
    case Body::capsule: {
      weft::CapsuleDesc desc;
      desc.a = to_weft(centre - Vec{size, 0, 0});
      desc.b = to_weft(centre + Vec{size, 0, 0});
      desc.radius = size;
      return test.take(world.create_capsule(with(desc)));
    }
    case Body::cylinder: {
      weft::CylinderDesc desc;
      desc.a = to_weft(centre - Vec{0, size, 0});
      desc.b = to_weft(top);
      desc.radius = size;
      return test.take(world.create_cylinder(with(desc)));
    }
    case Body::box: {
      weft::BoxDesc desc;
      desc.center = to_weft(centre);
      desc.half = {size, size, size};
      return test.take(world.create_box(with(desc)));
    }
    case Body::mesh:
      break;
  }
  const double thickness = 0.1 * size, half = size - thickness;
  weft::MeshColliderDesc desc;
  desc.pose.translate = to_weft(centre);
  return add_collider(test, reference::box({half, half, half}), thickness, true, with(desc));
}

}  // namespace weft_tests
