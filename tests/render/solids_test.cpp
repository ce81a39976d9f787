#include "render/creases.h"
#include "render/solids.h"
#include "render/subdivide.h"
#include "render/weave.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace weft::render::test {
namespace {

TEST(Solids, BoundsOfEachShape) {
  SphereDesc sphere;
  sphere.center = {1, 2, 3};
  sphere.radius = 2;
  EXPECT_EQ(bounds_of(sphere).low, Vector3d(-1, 0, 1));
  CapsuleDesc capsule;
  capsule.a = {0, 0, 0};
  capsule.b = {0, 4, 0};
  capsule.radius = 1;
  EXPECT_EQ(bounds_of(capsule).high, Vector3d(1, 5, 1));
  BoxDesc box;
  box.center = {0, 0, 0};
  box.half = {1, 1, 1};
  box.axis = {0, 0, 3};
  box.degrees = 45;
  EXPECT_NEAR(bounds_of(box).high.x(), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(bounds_of(box).high.z(), 1, 1e-12);
  EXPECT_TRUE(bounds_of(PlaneDesc{}).empty());
  CylinderDesc disc;
  disc.a = {0, 0, 0};
  disc.b = {0, 0.04, 0};
  disc.radius = 0.8;
  EXPECT_NEAR(bounds_of(disc).low.y(), 0, 1e-12) << "its caps are flat";
  EXPECT_NEAR(bounds_of(disc).high.y(), 0.04, 1e-12);
  EXPECT_NEAR(bounds_of(disc).high.z(), 0.8, 1e-12);
}

TEST(Solids, ShapesGiveWayByTheirReachAndKeepHalf) {
  io::Scene scene;
  SphereDesc sphere;
  sphere.radius = 0.5;
  BoxDesc box;
  box.half = {0.5, 1, 2};
  CylinderDesc cylinder;
  cylinder.a = {0, -1, 0};
  cylinder.b = {0, 1, 0};
  cylinder.radius = 0.5;
  scene.colliders = {sphere, box, cylinder};
  const Box region{{-1, -1, -1}, {1, 1, 1}};
  for (const double reach : {0.0, 0.1, 7.0}) {
    const Solids solids = make_solids(scene, {reach, reach, reach}, region, nullptr);
    const double slack = std::min(reach, 0.25), hair = 1e-3;
    EXPECT_NEAR(solids.capsules[0].radius, 0.5 - slack, hair);
    EXPECT_GE(solids.capsules[0].radius, 0.25);
    EXPECT_NEAR(solids.solids[0].axes.col(2).norm(), 2 - slack, hair);
    EXPECT_NEAR(solids.solids[0].axes.col(0).norm(), 0.5 - slack, hair);
    EXPECT_NEAR(solids.solids[1].axes.col(0).norm(), 0.5 - slack, hair);
    EXPECT_NEAR(solids.solids[1].axes.col(2).norm(), 1 - slack, hair);
  }
}

// Where a picture looks, what is drawn of a sphere as large as the Earth lies on it.
TEST(Solids, SpheresMuchLargerThanTheSceneAreFineWhereItIs) {
  io::Scene scene;
  SphereDesc sphere;
  const Box region{{-1, -1, -1}, {1, 1, 1}};
  for (const double radius : {5.0, 300.0, 6371000.0}) {
    sphere.center = {0.5, -radius, 0};
    sphere.radius = radius;
    scene.colliders = {sphere};
    const Solids solids = make_solids(scene, {0}, region, nullptr);
    ASSERT_EQ(solids.solids.size(), 1u);
    const Solid& solid = solids.solids[0];
    const Triangles& mesh = solids.meshes[solid.mesh];
    size_t near = 0;
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
      Vector3d middle(0, 0, 0);
      for (size_t k = 0; k < 3; ++k) {
        const auto& v = mesh.vertices[mesh.indices[t + k]];
        middle += (solid.axes * Vector3d(v[0], v[1], v[2]) + solid.center) / 3;
      }
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
  const Triangles sharp = with_creases(cube, {0, 2, 1, 0, 3, 2, 0, 1, 4}).triangles;
  ASSERT_EQ(sharp.indices.size(), 9u);
  EXPECT_EQ(sharp.vertices.size(), 4u + 3u) << "the edge 0-1 has normals of its own on both sides";
  EXPECT_EQ(sharp.vertices[sharp.indices[0]][5], -1);
  EXPECT_EQ(sharp.vertices[sharp.indices[6]][4], -1);
  const std::vector<Vector3d> fold{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {0, -1, 0.1}};
  const Triangles smooth = with_creases(fold, {0, 1, 2, 1, 0, 3}).triangles;
  EXPECT_EQ(smooth.vertices.size(), 4u);
  EXPECT_NEAR(double(smooth.vertices[smooth.indices[0]][5]), 1, 1e-6);
}

// A fold of two triangles, one of them large: the edge that they share is cut once.
TEST(Subdivided, IsTheSameSurfaceInPieces) {
  io::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0, 0.3}};
  mesh.triangles = {0, 1, 2, 1, 0, 3};
  const io::Mesh fine = subdivided(mesh, 0.3);
  std::map<std::pair<uint32_t, uint32_t>, int> sides;
  double area = 0;
  for (size_t t = 0; t < fine.triangles.size(); t += 3) {
    const uint32_t* v = &fine.triangles[t];
    const Vector3d a = vector(fine.positions[v[0]]), b = vector(fine.positions[v[1]]),
                   c = vector(fine.positions[v[2]]);
    area += 0.5 * (b - a).cross(c - a).norm();
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t i = v[k], j = v[(k + 1) % 3];
      EXPECT_LE((vector(fine.positions[i]) - vector(fine.positions[j])).norm(), 0.3);
      sides[{i, j}] += 1;
    }
  }
  EXPECT_NEAR(area, 0.5 + 0.15, 1e-12);
  size_t inner = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1) << "both triangles of an edge run along it in opposite directions";
    const bool on_fold = fine.positions[side.first].y == 0 && fine.positions[side.first].z == 0 &&
                         fine.positions[side.second].y == 0 && fine.positions[side.second].z == 0;
    inner += on_fold && sides.count({side.second, side.first}) == 1;
  }
  EXPECT_EQ(inner, 8u) << "four pieces of the shared edge, from both sides";
}

TEST(Solids, TheGroundIsNotDrawnTwice) {
  io::Scene scene;
  PlaneDesc plane;
  plane.normal = {0, 1, 0};
  scene.colliders = {plane};
  const PlaneDesc* ground = ground_plane(scene, Vector3d::UnitY());
  ASSERT_NE(ground, nullptr);
  const Box region{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_TRUE(make_solids(scene, {0}, region, ground).solids.empty());
  EXPECT_EQ(make_solids(scene, {0}, region, nullptr).solids.size(), 1u);
  EXPECT_EQ(ground_plane(scene, Vector3d::UnitX()), nullptr);
}

TEST(Solids, FormsAreClosedAndFaceOutwards) {
  for (const Triangles& form : {cylinder_form(), box_form()}) {
    double volume = 0;
    for (size_t t = 0; t < form.indices.size(); t += 3) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) {
        const auto& v = form.vertices[form.indices[t + size_t(k)]];
        corners.col(k) = Vector3d(v[0], v[1], v[2]);
      }
      volume += corners.determinant() / 6;
    }
    EXPECT_NEAR(volume, form.vertices.size() == 24 ? 8 : 2 * M_PI, 0.02);
  }
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
