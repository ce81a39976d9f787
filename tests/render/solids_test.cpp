#include "render/cloths.h"
#include "render/solids.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cmath>

namespace weft::render::test {
namespace {

const Box region{{-1, -1, -1}, {1, 1, 1}};

Solid solid_of(const io::ColliderScene& collider) {
  io::Scene scene;
  scene.colliders = {collider};
  return make_solids(scene, region)[0];
}

double volume_of(const Triangles& surface) {
  double volume = 0;
  for (size_t t = 0; t < surface.indices.size(); t += 3) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = surface.places[surface.indices[t + size_t(k)]];
    volume += corners.determinant() / 6;
  }
  return volume;
}

SphereDesc a_sphere() {
  SphereDesc sphere;
  sphere.center = {1, 2, 3};
  sphere.radius = 2;
  return sphere;
}
CapsuleDesc a_capsule() {
  CapsuleDesc capsule;
  capsule.a = {0, 0, 0};
  capsule.b = {0, 4, 0};
  capsule.radius = 1;
  return capsule;
}
CylinderDesc a_cylinder() {
  CylinderDesc disc;
  disc.a = {0, 0, 0};
  disc.b = {0, 0.04, 0};
  disc.radius = 0.8;
  return disc;
}
BoxDesc a_box() {
  BoxDesc box;
  box.center = {0, 0, 0};
  box.half = {1, 1, 1};
  box.axis = {0, 0, 3};
  box.degrees = 45;
  return box;
}

TEST(Solids, AreAsLargeAsTheyAreSimulated) {
  EXPECT_LT((solid_of(a_sphere()).box.low - Vector3d(-1, 0, 1)).norm(), 1e-12);
  EXPECT_LT((solid_of(a_sphere()).box.high - Vector3d(3, 4, 5)).norm(), 1e-12);
  EXPECT_LT((solid_of(a_capsule()).box.low - Vector3d(-1, -1, -1)).norm(), 1e-12);
  EXPECT_LT((solid_of(a_capsule()).box.high - Vector3d(1, 5, 1)).norm(), 1e-12);
  EXPECT_LT((solid_of(a_cylinder()).box.low - Vector3d(-0.8, 0, -0.8)).norm(), 1e-12);
  EXPECT_LT((solid_of(a_cylinder()).box.high - Vector3d(0.8, 0.04, 0.8)).norm(), 1e-12);
  const double wide = std::sqrt(2.0);
  EXPECT_LT((solid_of(a_box()).box.low - Vector3d(-wide, -wide, -1)).norm(), 1e-12);
  EXPECT_LT((solid_of(a_box()).box.high - Vector3d(wide, wide, 1)).norm(), 1e-12);
}

TEST(Solids, AreClosedAndFaceOutwards) {
  const double pi = M_PI;
  EXPECT_NEAR(volume_of(solid_of(a_sphere()).surface) / (32 * pi / 3), 1, 5e-3);
  EXPECT_NEAR(volume_of(solid_of(a_capsule()).surface) / (16 * pi / 3), 1, 5e-3);
  EXPECT_NEAR(volume_of(solid_of(a_cylinder()).surface) / (0.0256 * pi), 1, 5e-3);
  EXPECT_NEAR(volume_of(solid_of(a_box()).surface), 8, 1e-12);
}

TEST(Solids, HaveNormalsThatFaceAsTheirTrianglesDo) {
  for (const io::ColliderScene& collider : std::vector<io::ColliderScene>{
           a_sphere(), a_capsule(), a_cylinder(), a_box(), PlaneDesc{}}) {
    const Triangles surface = solid_of(collider).surface;
    for (size_t t = 0; t < surface.indices.size(); t += 3) {
      const uint32_t* v = &surface.indices[t];
      const Vector3d a = surface.places[v[0]];
      const Vector3d area = (surface.places[v[1]] - a).cross(surface.places[v[2]] - a);
      if (area.norm() < 1e-9) continue;
      for (size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(surface.normals[v[k]].norm(), 1, 1e-12);
        EXPECT_GT(surface.normals[v[k]].dot(area.normalized()), 0.9) << collider.index();
      }
    }
  }
}

// Where a picture looks, what is drawn of a sphere as large as the Earth lies on it.
TEST(Solids, SpheresMuchLargerThanTheSceneAreFineWhereItIs) {
  SphereDesc sphere;
  for (const double radius : {5.0, 300.0, 6371000.0}) {
    sphere.center = {0.5, -radius, 0};
    sphere.radius = radius;
    const Triangles surface = solid_of(sphere).surface;
    size_t near = 0;
    for (size_t t = 0; t < surface.indices.size(); t += 3) {
      Vector3d middle(0, 0, 0);
      for (size_t k = 0; k < 3; ++k) middle += surface.places[surface.indices[t + k]] / 3;
      const double above = (middle - vector(sphere.center)).norm() - radius;
      EXPECT_LT(above, 1e-9 * radius);
      if (middle.norm() > 1.8) continue;
      ++near;
      EXPECT_NEAR(above, 0, 3e-3) << radius;
    }
    EXPECT_GT(near, 100u);
  }
}

// A cube has edges, a ball of the same kind of triangles has none.
TEST(Creases, AreWhereTrianglesMeetAtAnAngle) {
  const std::vector<Vector3d> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  const Triangles sharp = with_creases(cube, {0, 2, 1, 0, 3, 2, 0, 1, 4});
  ASSERT_EQ(sharp.indices.size(), 9u);
  EXPECT_EQ(sharp.places.size(), 4u + 3u) << "the edge 0-1 has normals of its own on both sides";
  EXPECT_EQ(sharp.normals[sharp.indices[0]].z(), -1);
  EXPECT_EQ(sharp.normals[sharp.indices[6]].y(), -1);
  const std::vector<Vector3d> fold{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {0, -1, 0.1}};
  const Triangles smooth = with_creases(fold, {0, 1, 2, 1, 0, 3});
  EXPECT_EQ(smooth.places.size(), 4u);
  EXPECT_NEAR(smooth.normals[smooth.indices[0]].z(), 1, 1e-6);
}

TEST(Solids, TheGroundIsThePlaneThatFacesUpTheMost) {
  io::Scene scene;
  PlaneDesc wall, slope, level;
  wall.normal = {1, 0, 0};
  slope.normal = {0.5, 1, 0};
  level.normal = {0, 2, 0};
  scene.colliders = {wall, slope, level, a_sphere()};
  const std::vector<Solid> solids = make_solids(scene, region);
  ASSERT_EQ(solids.size(), 4u);
  EXPECT_EQ(solids[0].kind, Solid::Kind::plane);
  EXPECT_EQ(solids[1].kind, Solid::Kind::plane);
  EXPECT_EQ(solids[2].kind, Solid::Kind::ground);
  EXPECT_EQ(solids[3].kind, Solid::Kind::body);
  scene.gravity = {-9.81, 0, 0};
  EXPECT_EQ(make_solids(scene, region)[0].kind, Solid::Kind::ground);
}

TEST(Weave, ShowsEveryVertexSomehow) {
  io::Scene scene;
  scene.cloths.resize(2);
  scene.cloths[0].shape = io::GridShape{1, 4, 1, 1, Stencil::quad4};
  scene.cloths[1].shape = io::NetworkShape{};
  io::Surface surface;
  surface.positions.resize(7);
  surface.edges = {{4, 5}};
  surface.parts = {{"rope", 0, 4, 0, 0, 0, 0}, {"net", 4, 3, 0, 0, 0, 1}};
  const auto shown = bars(scene, surface);
  const std::vector<std::array<uint32_t, 2>> want{{4, 5}, {0, 1}, {1, 2}, {2, 3}, {6, 6}};
  EXPECT_EQ(shown, want);
  EXPECT_EQ(weave_vertices(scene, surface).size(), 7u);
}

}  // namespace
}  // namespace weft::render::test
