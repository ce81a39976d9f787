// A closed mesh that is drawn smaller by what its edges stick out lies below the cloth on it.
#include "render/reach.h"
#include "render/ridges.h"
#include "render/solids.h"

#include "io/build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace weft::render::test {
namespace {

/// Six squares of two triangles.
io::Mesh box_mesh(const Vector3d& half) {
  const Triangles box = box_form();
  io::Mesh mesh;
  for (const auto& v : box.vertices) {
    mesh.positions.push_back(
        {double(v[0]) * half.x(), double(v[1]) * half.y(), double(v[2]) * half.z()});
  }
  mesh.triangles = box.indices;
  return mesh;
}

/// Radius 0.3, of flat pieces.
io::Mesh ball_mesh(uint32_t around, uint32_t rings) {
  io::Mesh mesh;
  const double pi = std::numbers::pi;
  mesh.positions.push_back({0, 0.3, 0});
  for (uint32_t i = 1; i < rings; ++i) {
    for (uint32_t j = 0; j < around; ++j) {
      const double t = pi * i / rings, p = 2 * pi * j / around;
      mesh.positions.push_back(
          {0.3 * std::sin(t) * std::cos(p), 0.3 * std::cos(t), 0.3 * std::sin(t) * std::sin(p)});
    }
  }
  mesh.positions.push_back({0, -0.3, 0});
  const auto last = uint32_t(mesh.positions.size() - 1);
  const auto at = [&](uint32_t i, uint32_t j) { return 1 + (i - 1) * around + j % around; };
  for (uint32_t j = 0; j < around; ++j) {
    for (const uint32_t v :
         {0u, at(1, j + 1), at(1, j), last, at(rings - 1, j), at(rings - 1, j + 1)}) {
      mesh.triangles.push_back(v);
    }
    for (uint32_t i = 1; i + 1 < rings; ++i) {
      for (const uint32_t v :
           {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)}) {
        mesh.triangles.push_back(v);
      }
    }
  }
  return mesh;
}

io::MeshColliderScene collider_of(io::Mesh mesh, bool closed = true) {
  io::MeshColliderScene collider;
  collider.mesh = std::make_shared<const io::Mesh>(std::move(mesh));
  collider.closed = closed;
  return collider;
}

Ridges::Found found_by(const io::MeshColliderScene& collider,
                       const std::array<Vector3d, 3>& triangle) {
  Ridges::Found found;
  Ridges(collider).add(triangle, 0, found);
  return found;
}

// A plane that cuts an edge of a right angle at a height of h, turned by an angle, is below the
// faces when they move in by h / (sine + cosine).
TEST(Ridges, DepthBelowAnEdgeIsTheClosedForm) {
  const io::MeshColliderScene cube = collider_of(box_mesh({1, 1, 1}));
  for (const double degrees : {45.0, 60.0, 33.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle), height = 0.05;
    const Vector3d normal(c, s, 0), across(-s, c, 0), up(0, 0, 1);
    const Vector3d middle = Vector3d(1, 1, 0) - height * normal;
    for (const double side : {1.0, -1.0}) {  // of either orientation
      const Ridges::Found found = found_by(
          cube, {Vector3d(middle + side * 0.4 * across - 0.3 * up),
                 Vector3d(middle - side * 0.4 * across - 0.3 * up), Vector3d(middle + 0.5 * up)});
      EXPECT_NEAR(found.depth, height / (s + c), 1e-12) << degrees;
      EXPECT_TRUE(found.cut);
    }
  }
}

TEST(Ridges, ATriangleBeyondAPlateIsNotInIt) {
  const io::MeshColliderScene plate = collider_of(box_mesh({1, 0.01, 1}));
  const Ridges::Found below = found_by(
      plate, {Vector3d(0.9, -0.02, 0.9), Vector3d(1.2, -0.02, 0.9), Vector3d(0.9, -0.02, 1.2)});
  EXPECT_EQ(below.depth, 0);
  EXPECT_FALSE(below.cut);
  EXPECT_LT(Ridges(plate).most_hidden(), 0.01) << "a thin mesh is not turned inside out";
}

TEST(Ridges, OpenMeshesAreOnlyCut) {
  const io::MeshColliderScene ball = collider_of(ball_mesh(12, 6), false);
  const std::array<Vector3d, 3> deep{Vector3d(-1, 0.2, -1), Vector3d(1, 0.2, -1),
                                     Vector3d(0, 0.2, 1)};
  EXPECT_TRUE(found_by(ball, deep).cut);
  EXPECT_EQ(found_by(ball, deep).depth, 0);
  EXPECT_FALSE(found_by(ball, {deep[0] + Vector3d(0, 1, 0), deep[1] + Vector3d(0, 1, 0),
                               deep[2] + Vector3d(0, 1, 0)})
                   .cut);
}

TEST(Ridges, MoveAndTurnWithTheirCollider) {
  io::MeshColliderScene box = collider_of(box_mesh({1, 2, 3}));
  box.scale = 0.5;
  box.pose.axis = {0, 0, 1};
  box.pose.degrees = 90;
  box.pose.translate = {10, 0, 0};
  box.velocity = {0, 1, 0};
  const Ridges ridges(box);
  EXPECT_TRUE(ridges.enclose({10.9, 5.4, 1.4}, 5));
  EXPECT_FALSE(ridges.enclose({10.4, 5.9, 1.4}, 5)) << "turned: it is wide along x";
  EXPECT_FALSE(ridges.enclose({10.9, 0.4, 1.4}, 5)) << "it has moved";
}

// Between a picture that hides a cut and one that cannot lies a warning.
TEST(Ridges, WhatNoPictureHidesIsAProblem) {
  io::Scene scene;
  scene.cloths.emplace_back();
  scene.colliders = {PlaneDesc{}, collider_of(box_mesh({1, 1, 1})),
                     collider_of(box_mesh({1, 1, 1}), false)};
  const auto lines_at = [&](double height, std::vector<double>& depths) {
    io::Surface surface;
    surface.positions = {{2, height - 1, 0.5}, {0, height + 1, 0.5}, {1, height, -0.2}};
    surface.triangles = {{0, 1, 2}};
    Reach reach(scene, surface);
    reach.add(surface, 0);
    depths = reach.depths();
    return reach.problems();
  };
  std::vector<double> depths;
  const auto shallow = lines_at(0.9, depths);
  EXPECT_NEAR(depths[1], 0.05, 1e-12);
  EXPECT_EQ(depths[2], 0) << "open: drawn as it is";
  ASSERT_EQ(shallow.size(), 1u);
  EXPECT_EQ(shallow[0].find("$.colliders[2].mesh: shows through cloth"), 0u) << shallow[0];
  const auto deep = lines_at(0.2, depths);
  EXPECT_NEAR(depths[1], 0.2, 1e-12) << "a fifth of its size";
  EXPECT_EQ(deep.size(), 2u);
  EXPECT_TRUE(lines_at(1.1, depths).empty());
}

/// Triangles with their corners outside of a mesh.
std::vector<std::array<Vector3d, 3>> cutting_triangles(const Ridges& ridges, double reach) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<std::array<Vector3d, 3>> all;
  while (all.size() < 300) {
    const Vector3d middle = reach * Vector3d(unit(random), unit(random), unit(random));
    std::array<Vector3d, 3> t;
    bool outside = true;
    for (Vector3d& corner : t) {
      corner = middle + 0.15 * Vector3d(unit(random), unit(random), unit(random));
      outside = outside && !ridges.enclose(corner, 0);
    }
    if (outside) all.push_back(t);
  }
  return all;
}

TEST(Ridges, NothingOfATriangleIsInsideOfAMeshThatWasShrunkByTheDepth) {
  const io::Mesh meshes[] = {box_mesh({0.3, 0.3, 0.3}), box_mesh({0.3, 0.2, 0.4}), ball_mesh(16, 8),
                             ball_mesh(24, 12)};
  size_t cuts = 0;
  for (const io::Mesh& mesh : meshes) {
    const io::MeshColliderScene collider = collider_of(mesh);
    const Ridges ridges(collider);
    size_t inside = 0, samples = 0;
    for (const auto& t : cutting_triangles(ridges, 0.4)) {
      Ridges::Found found;
      ridges.add(t, 0, found);
      cuts += found.depth > 1e-3;
      io::Mesh smaller = mesh;
      const std::vector<Vector3d> moved = shrunk(mesh, 1.02 * found.depth + 1e-9);
      for (size_t v = 0; v < moved.size(); ++v) {
        smaller.positions[v] = {moved[v].x(), moved[v].y(), moved[v].z()};
      }
      const Ridges after(collider_of(smaller));
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; i + j <= 8; ++j) {
          const double u = i / 8.0, v = j / 8.0;
          ++samples;
          inside += after.enclose(u * t[0] + v * t[1] + (1 - u - v) * t[2], 0);
        }
      }
    }
    EXPECT_EQ(inside, 0u) << "of " << samples;
  }
  EXPECT_GT(cuts, 50u);
}

}  // namespace
}  // namespace weft::render::test
