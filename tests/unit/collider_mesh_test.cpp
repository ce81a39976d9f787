#include "scene/collider_mesh.h"

#include <gtest/gtest.h>

#include "reference/mesh_on_device.h"
#include "reference/mesh_shapes.h"
#include "reference/random.h"

#include "base/message_host.h"

namespace weft::scene {
namespace {

using reference::cook;
using reference::Triangles;
using reference::Vec;

std::string refusal(const Triangles& mesh, double thickness, bool closed) {
  try {
    cook(mesh, thickness, closed);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}
void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(ColliderMesh, EveryPointOfACellFindsItsNearestTriangleInTheList) {
  reference::SplitMix random(1);
  for (const double thickness : {0.003, 0.03, 0.3}) {
    const Triangles mesh = reference::ball(0.5, 3, 1.1);
    const CookedColliderMesh cooked = cook(mesh, thickness, false);
    for (int i = 0; i < 3000; ++i) {
      const Vec x = mesh.vertices[random.bits() % mesh.vertices.size()] + random.noise(thickness);
      const double distance = reference::distance_to_mesh(mesh, x);
      if (distance > thickness) continue;
      const auto cell = [&](double at, double low) {
        return size_t(std::floor((at - low) / cooked.cell_size));
      };
      const size_t number =
          (cell(x.z, cooked.grid_low.z) * size_t(cooked.cells[1]) + cell(x.y, cooked.grid_low.y)) *
              size_t(cooked.cells[0]) +
          cell(x.x, cooked.grid_low.x);
      double found = 1e300;
      ASSERT_GE(cooked.cell_start[number], 0);
      for (size_t e = size_t(cooked.cell_start[number]);; ++e) {
        const int32_t entry = cooked.entry_triangle[e];
        const double* c = &cooked.corners[size_t(entry < 0 ? ~entry : entry) * 9];
        const Vec p = reference::nearest_on_triangle({c[0], c[1], c[2]}, {c[3], c[4], c[5]},
                                                     {c[6], c[7], c[8]}, x);
        found = std::fmin(found, reference::length(x - p));
        if (entry < 0) break;
      }
      ASSERT_NEAR(found, distance, 1e-14);
    }
  }
}

TEST(ColliderMesh, ListsAreShortAndMemoryFollowsTheTriangles) {
  for (const int divisions : {3, 4, 5}) {
    const Triangles mesh = reference::ball(1, divisions);
    const CookedColliderMesh cooked = cook(mesh, 0.02, true);
    TriangleGrid<float> grid{};
    plan::ArrayBytes bytes;
    grid.arrays(bytes, api::grid_counts(cooked));
    EXPECT_LT(double(bytes.bytes()) / double(mesh.faces.size()), 1000) << divisions;
  }
}

TEST(ColliderMesh, CookingTwiceGivesTheSame) {
  const Triangles mesh = reference::ball(1, 4, 1.2);
  const CookedColliderMesh a = cook(mesh, 0.02, true), b = cook(mesh, 0.02, true);
  EXPECT_EQ(a.cell_start, b.cell_start);
  EXPECT_EQ(a.entry_triangle, b.entry_triangle);
  EXPECT_EQ(a.planes, b.planes);
  EXPECT_EQ(a.sides, b.sides);
}

TEST(ColliderMesh, TrianglesWithoutAreaAreLeftOutAndReported) {
  Triangles mesh = reference::box({1, 1, 1});
  mesh.faces.push_back({3, 3, 5});
  const CookedColliderMesh cooked = cook(mesh, 0.1, true);
  EXPECT_EQ(cooked.triangles, 12u);
  ASSERT_EQ(cooked.diagnostics.size(), 1u);
  EXPECT_EQ(cooked.diagnostics[0].element, 12u);
  expect_words(cooked.diagnostics[0].text.c_str(), {"1 triangles", "12"});
}

TEST(ColliderMesh, SplitVerticesCloseAMesh) {
  Triangles split;
  const Triangles mesh = reference::box({1, 1, 1});
  for (const auto& f : mesh.faces) {
    const auto v = static_cast<uint32_t>(split.vertices.size());
    for (const uint32_t corner : f) split.vertices.push_back(mesh.vertices[corner]);
    split.faces.push_back({v, v + 1, v + 2});
  }
  EXPECT_EQ(cook(split, 0.1, true).sides, cook(mesh, 0.1, true).sides);
}

TEST(ColliderMesh, AMeshThatIsNotClosedIsRefusedByItsEdge) {
  Triangles mesh = reference::box({1, 1, 1});
  mesh.faces.erase(mesh.faces.begin());
  expect_words(refusal(mesh, 0.1, true), {"edge 0-1", "triangle 3 only", "(", ")"});
  EXPECT_EQ(refusal(mesh, 0.1, false), "");

  mesh = reference::box({1, 1, 1});
  mesh.faces.push_back({0, 1, 7});
  expect_words(refusal(mesh, 0.1, true), {"edge 1-0", "3 triangles", "0, 4 and 12"});

  mesh = reference::box({1, 1, 1});
  std::swap(mesh.faces[0][0], mesh.faces[0][1]);
  expect_words(refusal(mesh, 0.1, true), {"triangles 0 and", "vertex", "turn one"});

  mesh = reference::box({1, 1, 1});
  for (auto& f : mesh.faces) std::swap(f[0], f[1]);
  expect_words(refusal(mesh, 0.1, true), {"-8 m3", "reverse the triangles"});
}

TEST(ColliderMesh, WhatCannotBeUsedIsRefusedByElementAndValue) {
  Triangles mesh = reference::box({1, 1, 1});
  expect_words(refusal(mesh, 0, true), {"thickness is 0"});
  expect_words(refusal(mesh, 1e-7, true), {"thickness is 1e-07", "pass through", "give at least"});
  expect_words(refusal(mesh, std::nan(""), true), {"thickness is"});
  mesh.faces[5][1] = 8;
  expect_words(refusal(mesh, 0.1, true), {"triangle 5", "vertex 8", "has 8"});
  mesh = reference::box({1, 1, 1});
  mesh.vertices[3].y = std::nan("");
  expect_words(refusal(mesh, 0.1, true), {"vertex 3"});
  expect_words(refusal(Triangles{}, 0.1, true), {"0 triangles", "none has an area"});
  expect_words(refusal(Triangles{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}, 0.1, false),
               {"1 triangles", "none has an area"});
}

TEST(ColliderMesh, TheScaleIsCheckedAndApplied) {
  const std::vector<double3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<uint32_t> indices{0, 1, 2, 0};
  ColliderMeshDesc desc;
  desc.positions = View<double3>(positions);
  desc.indices = View<uint32_t>(indices.data(), 3);
  desc.scale = 3;
  CookedColliderMesh cooked(std::pmr::new_delete_resource());
  cook_collider_mesh(desc, cooked);
  EXPECT_EQ(cooked.corners[3], 3);
  EXPECT_LE(cooked.zone_low.z, -desc.thickness);
  EXPECT_GE(cooked.zone_high.x, 3 + desc.thickness);
  for (const double scale : {0.0, -1.0, 1e10}) {
    desc.scale = scale;
    CookedColliderMesh refused(std::pmr::new_delete_resource());
    EXPECT_THROW(cook_collider_mesh(desc, refused), InvalidInput) << scale;
  }
  desc.scale = 1;
  desc.indices = indices;
  CookedColliderMesh refused(std::pmr::new_delete_resource());
  EXPECT_THROW(cook_collider_mesh(desc, refused), InvalidInput);
}

}  // namespace
}  // namespace weft::scene
