// The host's stencil tables and the kernels' must be the same: presence bit k, stiffness k and
// offset k belong together.
#include "kernels/stencil.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "scene/grid.h"

namespace weft {
namespace {

template <class Kernel>
void expect_same(Stencil stencil) {
  constexpr auto kernel = Kernel::offsets();
  const scene::StencilTable& host = scene::stencil_table(stencil);
  ASSERT_EQ(host.count, Kernel::neighbours);
  std::set<std::pair<int, int>> seen;
  int radius = 0;
  for (int k = 0; k < host.count; ++k) {
    EXPECT_EQ(host.offset[k].row, kernel.row[k]) << k;
    EXPECT_EQ(host.offset[k].column, kernel.column[k]) << k;
    const std::pair offset{host.offset[k].row, host.offset[k].column};
    EXPECT_TRUE(seen.empty() || *seen.rbegin() < offset) << "not ascending at " << k;
    seen.insert(offset);
    radius = std::max({radius, std::abs(offset.first), std::abs(offset.second)});
  }
  for (const auto& [row, column] : seen) EXPECT_TRUE(seen.count({-row, -column}));
  EXPECT_EQ(scene::stencil_radius(stencil), radius);
}

TEST(Stencil, HostAndKernelsAgree) {
  expect_same<WEFT_BACKEND_NS::Seed12>(Stencil::seed12);
  expect_same<WEFT_BACKEND_NS::Classic12>(Stencil::classic12);
  expect_same<WEFT_BACKEND_NS::Quad4>(Stencil::quad4);
  expect_same<WEFT_BACKEND_NS::Tri6>(Stencil::tri6);
}

TEST(Stencil, ClassesAreStretchShearAndBend) {
  const Stiffness k(1, 2, 3);
  EXPECT_EQ(scene::stencil_stiffness({1, 0}, k), 1);
  EXPECT_EQ(scene::stencil_stiffness({0, -1}, k), 1);
  EXPECT_EQ(scene::stencil_stiffness({-1, 1}, k), 2);
  EXPECT_EQ(scene::stencil_stiffness({2, 2}, k), 3);
  EXPECT_EQ(scene::stencil_stiffness({0, 2}, k), 3);
}

}  // namespace
}  // namespace weft
