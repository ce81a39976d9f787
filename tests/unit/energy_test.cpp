// What counts as stretch.
#include "scene/energy.h"

#include <gtest/gtest.h>

namespace weft::scene::test {
namespace {

std::vector<double3> at_rest(size_t n) { return std::vector<double3>(n); }

TEST(Energy, UnfoldingAMeshStretchesNothing) {
  // A book, nearly closed: the ends of its bend spring almost touch.
  const std::vector<double3> closed{{0, 0, 0}, {0, 1, 0}, {1, 0, 1e-4}, {1, 0, -1e-4}};
  const std::vector<double3> open{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  const std::vector<uint32_t> triangles{0, 1, 2, 1, 0, 3};
  MeshDesc desc;
  desc.positions = View<double3>(closed);
  desc.indices = triangles;
  desc.bend = true;
  desc.material.stiffness = Stiffness(100, 0, 10);
  CookedFabric fabric(std::pmr::get_default_resource());
  cook_mesh(desc, fabric);
  ASSERT_EQ(fabric.springs, 6u);
  const Energies e = energies({fabric, open, at_rest(4), nullptr, {0, 0, 0}, closed});
  EXPECT_LT(e.stretch, 1e-6);
  EXPECT_NEAR(e.elastic, 0.5 * 10 * (2 - 2e-4) * (2 - 2e-4), 1e-6);
  std::vector<double3> longer = open;
  longer[2] = {0, 0, 1.5};
  EXPECT_NEAR(energies({fabric, longer, at_rest(4), nullptr, {0, 0, 0}, closed}).stretch, 0.5,
              1e-6);
}

// The pole of a globe: two vertices that differ by a rounding error.
TEST(Energy, SpringsWithoutLengthHaveNoStretchAndAreADiagnostic) {
  const std::vector<double3> rest{{0, 0, 0}, {6e-17, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<double3> now = rest;
  now[1].x = 1e-3;
  now[2].x = 1.25;
  const std::vector<uint32_t> triangles{0, 1, 3, 1, 2, 3};
  MeshDesc desc;
  desc.positions = View<double3>(rest);
  desc.indices = triangles;
  CookedFabric fabric(std::pmr::get_default_resource());
  cook_mesh(desc, fabric);
  const Energies e = energies({fabric, now, at_rest(4), nullptr, {0, 0, 0}, rest});
  EXPECT_NEAR(e.stretch, 0.249, 1e-12);
  ASSERT_EQ(fabric.diagnostics.size(), 1u);
  EXPECT_EQ(fabric.diagnostics[0].element, 0u);
  EXPECT_EQ(std::string(fabric.diagnostics[0].text).find("1 springs have no length"), 0u);
}

TEST(Energy, BendSpringsOfAGridDoNotCount) {
  GridDesc desc;
  desc.rows = 1;
  desc.columns = 3;
  desc.width = 2;
  desc.height = 1;
  desc.stencil = Stencil::classic12;
  desc.material.stiffness = Stiffness(100, 50, 10);
  CookedFabric fabric(std::pmr::get_default_resource());
  cook_grid(desc, fabric);
  // A rest shape with its ends together, as of a grid that was given in a fold.
  const std::vector<double3> folded{{0, 0, 0}, {1, 0, 0}, {0.25, 0, 0}};
  const std::vector<double3> flat{{0, 0, 0}, {1, 0, 0}, {1.75, 0, 0}};
  fabric.rest_length = initial_rest_length;
  const Energies e = energies({fabric, flat, at_rest(3), nullptr, {0, 0, 0}, folded});
  EXPECT_LT(e.stretch, 1e-12);
  EXPECT_NEAR(e.elastic, 0.5 * 10 * 1.5 * 1.5, 1e-12);
}

TEST(Energy, ANetworkCountsEverySpring) {
  const std::vector<double3> positions{{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
  const std::vector<Spring> springs{{0, 1, 100, 0.8}, {1, 2, 100, 8}};
  NetworkDesc desc;
  desc.positions = View<double3>(positions);
  desc.springs = springs;
  CookedFabric fabric(std::pmr::get_default_resource());
  cook_network(desc, fabric);
  const Energies e = energies({fabric, positions, at_rest(3), nullptr, {0, 0, 0}, positions});
  EXPECT_NEAR(e.stretch, 0.25, 1e-12);
}

}  // namespace
}  // namespace weft::scene::test
