// A closed mesh that is drawn smaller by what its edges stick out lies below the cloth on it.
#include "render/ridges.h"
#include "render/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
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

Ridges ridges_of(const io::Mesh& mesh, bool closed = true) { return Ridges(mesh, 1, closed); }

double deepest(const Ridges::Depths& depths) {
  return *std::max_element(depths.begin(), depths.end());
}

Ridges::Depths found_by(const Ridges& ridges, const std::array<Vector3d, 3>& triangle) {
  Ridges::Depths depths = ridges.no_depths();
  ridges.add(triangle, depths);
  return depths;
}

// A plane that cuts an edge of a right angle at a height of h, turned by an angle, is below the
// faces when they move in by h / (sine + cosine).
TEST(Ridges, DepthBelowAnEdgeIsTheClosedForm) {
  const Ridges cube = ridges_of(box_mesh({1, 1, 1}));
  for (const double degrees : {45.0, 60.0, 33.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle), height = 0.05;
    const Vector3d normal(c, s, 0), across(-s, c, 0), up(0, 0, 1);
    const Vector3d middle = Vector3d(1, 1, 0) - height * normal;
    for (const double side : {1.0, -1.0}) {  // of either orientation
      const Ridges::Depths found = found_by(
          cube, {Vector3d(middle + side * 0.4 * across - 0.3 * up),
                 Vector3d(middle - side * 0.4 * across - 0.3 * up), Vector3d(middle + 0.5 * up)});
      EXPECT_NEAR(deepest(found), height / (s + c), 1e-12) << degrees;
    }
  }
}

TEST(Ridges, ATriangleBeyondAPlateIsNotInIt) {
  const Ridges plate = ridges_of(box_mesh({1, 0.01, 1}));
  const Ridges::Depths below = found_by(
      plate, {Vector3d(0.9, -0.02, 0.9), Vector3d(1.2, -0.02, 0.9), Vector3d(0.9, -0.02, 1.2)});
  EXPECT_EQ(deepest(below), 0);
  EXPECT_TRUE(plate.inset(below).by.empty());
}

// Half a ball, with its triangles one way round or the other. A cloth that lies in it is not below.
TEST(Ridges, OpenMeshesGiveWayWhereTheyAreRound) {
  io::Mesh bowl = ball_mesh(24, 12);
  io::Mesh half = bowl;
  half.triangles.clear();
  for (size_t t = 0; t < bowl.triangles.size(); t += 3) {
    const uint32_t* v = &bowl.triangles[t];
    const double top =
        std::max({bowl.positions[v[0]].y, bowl.positions[v[1]].y, bowl.positions[v[2]].y});
    if (top < 1e-9) half.triangles.insert(half.triangles.end(), v, v + 3);
  }
  const std::array<Vector3d, 3> below{Vector3d(-0.2, -0.29, -0.2), Vector3d(0.2, -0.29, -0.2),
                                      Vector3d(0, -0.29, 0.2)};
  std::array<Vector3d, 3> within = below;
  for (Vector3d& corner : within) corner *= 0.6;
  for (const bool inside_out : {false, true}) {
    if (inside_out) {
      for (size_t t = 0; t < half.triangles.size(); t += 3) {
        std::swap(half.triangles[t], half.triangles[t + 1]);
      }
    }
    const Ridges open = ridges_of(half, false);
    const Ridges::Depths depths = found_by(open, below);
    EXPECT_NEAR(deepest(depths), 0.01, 1e-3) << "it lies on a plane and sinks in by a centimetre";
    const Ridges::Inset inset = open.inset(depths);
    EXPECT_TRUE(inset.enough);
    Vector3d most(0, 0, 0);
    for (const Vector3d& by : inset.by) most = by.norm() > most.norm() ? by : most;
    EXPECT_LT(most.y(), -0.008) << "out is down";
    EXPECT_EQ(deepest(found_by(open, within)), 0);
  }
}

TEST(Ridges, EncloseWhatIsInside) {
  const Ridges box{box_mesh({1, 2, 3}), 0.5, true};
  EXPECT_TRUE(box.enclose({0.4, 0.9, 1.4}));
  EXPECT_FALSE(box.enclose({0.9, 0.4, 1.4}));
  EXPECT_FALSE(box.enclose({0.4, 0.9, 1.6}));
}

TEST(Ridges, AnOpenSheetHasNoSideToGiveWayTo) {
  io::Mesh roof;
  roof.positions = {{-1, 0, -1}, {-1, 0, 1}, {0, 0.05, -1}, {0, 0.05, 1}, {1, 0, -1}, {1, 0, 1}};
  roof.triangles = {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4};
  const Ridges open = ridges_of(roof, false);
  const std::array<Vector3d, 3> cut{Vector3d(-0.5, 0.04, 0), Vector3d(0.5, 0.04, 0),
                                    Vector3d(0, 0.04, 0.5)};
  EXPECT_FALSE(open.inset(found_by(open, cut)).enough);
  EXPECT_TRUE(open.inset(found_by(open, cut)).by.empty());
  EXPECT_TRUE(open.inset(open.no_depths()).enough);
}

// A cut through a thin plate cannot be hidden.
TEST(Ridges, WhatIsTooThinStaysAsItIs) {
  const std::array<Vector3d, 3> cut{Vector3d(2, -0.1, 0.5), Vector3d(0, 1.9, 0.5),
                                    Vector3d(1, 0.9, -0.2)};
  const Ridges cube = ridges_of(box_mesh({1, 1, 1})), plate = ridges_of(box_mesh({1, 1, 0.05}));
  const Ridges::Inset of_cube = cube.inset(found_by(cube, cut));
  EXPECT_TRUE(of_cube.enough);
  ASSERT_EQ(of_cube.by.size(), 24u);
  double farthest = 0;
  for (const Vector3d& in : of_cube.by) farthest = std::max(farthest, in.norm());
  EXPECT_NEAR(farthest, 0.05 * std::sqrt(3.0), 1e-9) << "the end of an edge that is cut";
  const Ridges::Inset of_plate = plate.inset(found_by(plate, cut));
  EXPECT_FALSE(of_plate.enough);
  for (const Vector3d& in : of_plate.by) EXPECT_LT(in.norm(), 0.05);
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
      outside = outside && !ridges.enclose(corner);
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
    const Ridges ridges = ridges_of(mesh);
    size_t inside = 0, samples = 0;
    for (const auto& t : cutting_triangles(ridges, 0.4)) {
      Ridges::Depths found = ridges.no_depths();
      ridges.add(t, found);
      cuts += deepest(found) > 1e-3;
      io::Mesh smaller = mesh;
      const Ridges::Inset inset = ridges.inset(found);
      EXPECT_TRUE(inset.enough);
      for (size_t v = 0; v < inset.by.size(); ++v) {
        const Vector3d in = 1.02 * inset.by[v];
        double3& p = smaller.positions[v];
        p = {p.x - in.x(), p.y - in.y(), p.z - in.z()};
      }
      const Ridges after = ridges_of(smaller);
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; i + j <= 8; ++j) {
          const double u = i / 8.0, v = j / 8.0;
          ++samples;
          inside += after.enclose(u * t[0] + v * t[1] + (1 - u - v) * t[2]);
        }
      }
    }
    EXPECT_EQ(inside, 0u) << "of " << samples;
  }
  EXPECT_GT(cuts, 50u);
}

}  // namespace
}  // namespace weft::render::test
