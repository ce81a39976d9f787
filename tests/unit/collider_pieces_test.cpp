// Closed collider meshes as people have them: pieces, cavities, copies, seams that rounding opened.
#include "scene/collider_mesh.h"

#include <gtest/gtest.h>

#include "reference/mesh_on_device.h"
#include "reference/mesh_shapes.h"

#include "base/message_host.h"

#include <algorithm>
#include <cmath>

namespace weft::scene {
namespace {

using reference::Triangles;
using reference::Vec;

struct Cooked {
  CookedColliderMesh mesh{std::pmr::new_delete_resource()};
  std::string refusal;
};

Cooked cook_mesh(const Triangles& t, double weld_distance = 0, bool closed = true) {
  std::vector<double3> positions;
  for (const Vec& v : t.vertices) positions.push_back({v.x, v.y, v.z});
  std::vector<uint32_t> indices;
  for (const auto& f : t.faces) indices.insert(indices.end(), f.begin(), f.end());
  ColliderMeshDesc desc;
  desc.positions = View<double3>(positions);
  desc.indices = indices;
  desc.thickness = 0.01;
  desc.closed = closed;
  desc.weld_distance = weld_distance;
  Cooked out;
  try {
    cook_collider_mesh(desc, out.mesh);
  } catch (const InvalidInput& e) {
    out.refusal = e.what();
  }
  return out;
}

void add(Triangles& to, Triangles piece, Vec shift = {0, 0, 0}, bool inverted = false) {
  const auto first = static_cast<uint32_t>(to.vertices.size());
  for (const Vec& v : piece.vertices) to.vertices.push_back(v + shift);
  for (auto f : piece.faces) {
    if (inverted) std::swap(f[1], f[2]);
    to.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  }
}

void expect_said(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
}

/// `turns[k]`: piece k, each inside the one before, is inside out.
std::string nested(std::initializer_list<bool> turns, bool balls) {
  Triangles mesh;
  double size = 2;
  for (const bool inverted : turns) {
    add(mesh, balls ? reference::ball(size, 1) : reference::box({size, size, size}), {0.1, 0, 0.1},
        inverted);
    size /= 2;
  }
  return cook_mesh(mesh).refusal;
}

TEST(ColliderPieces, AnInvertedPieceIsACavityInsideAnotherOnly) {
  for (const bool balls : {false, true}) {
    EXPECT_EQ(nested({false}, balls), "");
    EXPECT_EQ(nested({false, true}, balls), "") << "a hollow";
    EXPECT_EQ(nested({false, true, false}, balls), "") << "a body in a hollow";
    EXPECT_EQ(nested({false, true, false, true}, balls), "") << "and that hollow, too";
    EXPECT_EQ(nested({false, false}, balls), "") << "a body in a body";
    expect_said(nested({true}, balls), {"piece of triangle 0", "reverse the triangles"});
    expect_said(nested({true, false}, balls), {"piece of triangle 0"});
    expect_said(nested({false, true, true}, balls), {"does not lie in another piece"});
    expect_said(nested({true, true}, balls), {"piece of triangle"});
  }
}

TEST(ColliderPieces, AnInvertedPieceOutsideIsNamedWhereverItLies) {
  const Vec aside[] = {{3, 0, 0},  {-3, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 3},
                       {0, 0, -3}, {3, 3, 3},  {1, 0, 0}, {0, -1, 0}, {0, 0, 1.5}};
  for (const Vec& shift : aside) {
    Triangles mesh = reference::box({1, 1, 1});
    add(mesh, reference::box({0.5, 0.5, 0.5}), shift, true);
    expect_said(cook_mesh(mesh).refusal, {"the piece of triangle 1", "of 12 triangles", "-1 m3"});
    Triangles far;
    add(far, mesh, {1e5, -2e5, 3e5});
    expect_said(cook_mesh(far).refusal, {"the piece of triangle 1"});
  }
}

/// One face given both ways does not make the piece that others hold together turnable.
TEST(ColliderPieces, AFaceGivenBothWaysDoesNotTurnItsPiece) {
  for (size_t both = 0; both < 12; ++both) {
    Triangles out = reference::box({1, 1, 1}), inverted;
    add(inverted, out, {0, 0, 0}, true);
    for (Triangles* mesh : {&out, &inverted}) {
      auto f = mesh->faces[both];
      std::swap(f[1], f[2]);
      mesh->faces.push_back(f);
    }
    EXPECT_EQ(cook_mesh(out).refusal, "") << both;
    expect_said(cook_mesh(inverted).refusal, {"the piece of triangle", "-8 m3"});
  }
}

/// Weighted by angles, the normal of a box's corner is its diagonal however its faces are cut, and
/// that of an edge lies halfway between its two faces.
TEST(ColliderPieces, CornersAndEdgesOfABoxHaveTheNormalsOfAllTheirFaces) {
  Triangles box = reference::box({1, 1, 1});
  for (int first = 0; first < 3; ++first) {
    for (auto& f : box.faces) std::rotate(f.begin(), f.begin() + 1, f.end());
    const Cooked cooked = cook_mesh(box);
    ASSERT_EQ(cooked.refusal, "");
    ASSERT_EQ(cooked.mesh.triangles, 12u);
    const auto at = [&](uint32_t t, uint32_t c) {
      return &cooked.mesh.corners[9 * t + 3 * (c % 3)];
    };
    for (uint32_t t = 0; t < 12; ++t) {
      for (uint32_t c = 0; c < 3; ++c) {
        const double *edge = &cooked.mesh.sides[18 * t + 3 * c], *corner = edge + 9;
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(corner[k], at(t, c)[k] / std::sqrt(3.0), 1e-9) << t << " " << c;
        }
        double middle[3], size2 = 0;  // of a whole edge, or of a diagonal across a face
        for (int k = 0; k < 3; ++k) {
          middle[k] = (at(t, c)[k] + at(t, c + 1)[k]) / 2;
          size2 += middle[k] * middle[k];
        }
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(edge[k], middle[k] / std::sqrt(size2), 1e-9) << t << " " << c;
        }
      }
    }
  }
}

TEST(ColliderPieces, TouchInAVertexWithANormalEach) {
  const auto corner_normals = [](const Triangles& mesh, uint32_t faces) {
    const Cooked cooked = cook_mesh(mesh);
    EXPECT_EQ(cooked.refusal, "");
    return std::vector<double>(cooked.mesh.sides.begin(),
                               cooked.mesh.sides.begin() + std::ptrdiff_t(faces) * 18);
  };
  const Triangles alone = reference::box({1, 1, 1});
  Triangles two = alone;
  add(two, alone, {2, 2, 2});
  ASSERT_EQ(cook_mesh(two).mesh.triangles, 24u);
  EXPECT_EQ(corner_normals(two, 12).size(), corner_normals(alone, 12).size());
  // Triangles may be stored in another order: each normal of the first box is found again.
  const auto all = corner_normals(two, 24), some = corner_normals(alone, 12);
  for (size_t n = 0; n < some.size(); n += 3) {
    bool found = false;
    for (size_t m = 0; m < all.size() && !found; m += 3) {
      found = std::equal(&some[n], &some[n] + 3, &all[m]);
    }
    EXPECT_TRUE(found) << "normal " << n / 3;
  }
  for (size_t m = 0; m < all.size(); m += 3) {
    EXPECT_GT(std::fabs(all[m]) + std::fabs(all[m + 1]) + std::fabs(all[m + 2]), 0.9);
  }
}

TEST(ColliderPieces, WhatIsGivenAgainCountsOnce) {
  const Triangles once = reference::ball(1, 1);
  const Cooked expected = cook_mesh(once);
  for (const bool reversed : {false, true}) {
    Triangles twice = once;
    for (auto f : once.faces) {
      if (reversed) std::swap(f[1], f[2]);
      twice.faces.push_back({f[1], f[2], f[0]});
    }
    const Cooked same = cook_mesh(twice);
    ASSERT_EQ(same.refusal, "");
    EXPECT_EQ(same.mesh.triangles, expected.mesh.triangles);
    EXPECT_EQ(same.mesh.planes, expected.mesh.planes);
    EXPECT_EQ(same.mesh.sides, expected.mesh.sides);
    ASSERT_EQ(same.mesh.diagnostics.size(), 1u);
    EXPECT_EQ(same.mesh.diagnostics[0].element, once.faces.size());
    expect_said(same.mesh.diagnostics[0].text.c_str(), {"given again", "counts once"});

    Triangles copied = once;  // on vertices of its own
    add(copied, once, {0, 0, 0}, reversed);
    EXPECT_EQ(cook_mesh(copied).mesh.sides, expected.mesh.sides);
    EXPECT_EQ(cook_mesh(copied, 0, false).mesh.triangles, expected.mesh.triangles);
  }
}

TEST(ColliderPieces, OfTwoWaysTheOneThatEnclosesCounts) {
  const Triangles once = reference::box({1, 1, 1});
  Triangles mixed;
  mixed.vertices = once.vertices;
  for (size_t i = 0; i < once.faces.size(); ++i) {
    auto f = once.faces[i], g = f;
    std::swap(g[1], g[2]);
    mixed.faces.push_back(i % 3 == 0 ? f : g);
    mixed.faces.push_back(i % 3 == 0 ? g : f);
  }
  EXPECT_EQ(cook_mesh(mixed).refusal, "") << "every face both ways, in any order";
  Triangles one = once;
  auto f = one.faces[4];
  std::swap(f[1], f[2]);
  one.faces.insert(one.faces.begin(), f);
  EXPECT_EQ(cook_mesh(one).refusal, "") << "its neighbours say which way";
  EXPECT_EQ(cook_mesh(one).mesh.triangles, 12u);
}

/// A globe whose last meridian lies `gap` beside the first.
Triangles globe(double gap, double size, Vec at) {
  constexpr uint32_t around = 12, down = 6, width = around + 1;
  Triangles mesh;
  for (uint32_t j = 0; j <= down; ++j) {
    for (uint32_t i = 0; i <= around; ++i) {
      const double pi = 3.14159265358979323846, t = pi * j / down,
                   p = 2 * pi * (i % around) / around;
      Vec v{std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)};
      if (i == around) v.x += gap;
      mesh.vertices.push_back(size * v + at);
    }
  }
  for (uint32_t j = 0; j < down; ++j) {
    for (uint32_t i = 0; i < around; ++i) {
      const uint32_t a = j * width + i, b = a + 1, c = a + width, d = c + 1;
      if (j > 0) mesh.faces.push_back({a, b, c});
      if (j + 1 < down) mesh.faces.push_back({b, d, c});
    }
  }
  return mesh;
}

TEST(ColliderPieces, SeamsThatRoundingOpenedAreClosed) {
  for (const double size : {1e-3, 1.0, 1e3}) {
    EXPECT_EQ(cook_mesh(globe(4e-17, size, {0, 0, 0})).refusal, "");
    EXPECT_EQ(cook_mesh(globe(1e-15, size, {0, 0, 0})).refusal, "");
    EXPECT_EQ(cook_mesh(globe(1e-7, size, {0, 0, 0})).refusal, "") << "single precision";
  }
  EXPECT_EQ(cook_mesh(globe(1e-13, 1, {100, 0, -100})).refusal, "");
}

TEST(ColliderPieces, AnOpenSeamSaysHowNearItIs) {
  const std::string refusal = cook_mesh(globe(3e-4, 1, {0, 0, 0})).refusal;
  expect_said(refusal, {"triangle", "only", "0.0003 m apart", "weld_distance"});
  EXPECT_EQ(cook_mesh(globe(3e-4, 1, {0, 0, 0}), 4e-4).refusal, "");
  EXPECT_NE(cook_mesh(globe(3e-4, 1, {0, 0, 0}), 2e-4).refusal, "");
  EXPECT_EQ(cook_mesh(globe(3e-4, 1, {0, 0, 0}), 0, false).refusal, "");
  for (const double bad : {-1.0, std::nan(""), HUGE_VAL}) {
    expect_said(cook_mesh(globe(0, 1, {0, 0, 0}), bad).refusal, {"weld_distance"});
  }
}

TEST(ColliderPieces, AnEdgeOfFourTrianglesIsRefused) {
  Triangles mesh = reference::box({1, 1, 1});
  add(mesh, reference::box({1, 1, 1}), {2, 2, 0});  // they share an edge
  expect_said(cook_mesh(mesh).refusal, {"has 4 triangles", "closed to false"});
}

TEST(ColliderPieces, ManyCavitiesTakeNoLongerThanTheirTriangles) {
  Triangles mesh = reference::box({100, 100, 100});
  for (int i = 0; i < 1000; ++i) {
    add(mesh, reference::box({1, 1, 1}),
        {-90.0 + 20 * (i % 10), -90.0 + 20 * (i / 10 % 10), -90.0 + 20 * (i / 100)}, true);
  }
  EXPECT_EQ(cook_mesh(mesh).refusal, "");
  add(mesh, reference::box({1, 1, 1}), {0, 101.5, 0}, true);
  expect_said(cook_mesh(mesh).refusal, {"the piece of triangle 12012"});
}

}  // namespace
}  // namespace weft::scene
