// Hard case 18: ten million particles, where 32-bit byte offsets and float indices end.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "weft/weft.hpp"

namespace weft_tests {
namespace {

TEST(TenMillionParticles, FallFreelyToTheLastOneInTheMemoryThatThePlanPredicts) {
  constexpr uint32_t n = 3163;
  constexpr int substeps = 8;
  auto context = weft::Context::create();
  ASSERT_TRUE(context);
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.width = grid.height = n - 1;  // spacing 1: rest lengths are exact, so no spring pulls
  grid.material.mass.value = double(n) * n;
  auto fabric = context->cook(grid);
  ASSERT_TRUE(fabric);
  EXPECT_EQ(fabric->vertex_count(), 10004569u);
  EXPECT_EQ(2 * fabric->spring_count(), 119966284u);

  weft::WorldDesc desc;
  desc.substeps = substeps;
  auto world = context->create_world(desc);
  ASSERT_TRUE(world);
  weft::ClothDesc cloth;
  cloth.fabric = *fabric;
  const auto id = world->create_cloth(cloth);
  ASSERT_TRUE(id);
  const auto plan = world->plan();
  ASSERT_TRUE(plan);

  const double dt = 0.9 * world->stability().dt_bound;
  ASSERT_EQ(world->step(substeps * dt), weft::Status::ok);
  const weft::Stats stats = world->stats();
  EXPECT_NEAR(double(plan->bytes_total), double(stats.bytes_total),
              0.05 * double(stats.bytes_total));
  EXPECT_EQ(stats.springs, 59983142u);

  std::vector<weft::float3> x(fabric->vertex_count());
  ASSERT_EQ(world->read_positions(*id, x.data()), weft::Status::ok);
  // From rest with the Taylor start: exactly g t^2/2, in whole steps; each of the eight rounds to
  // the 1.2e-4 m that a float resolves 1581 m from the cloth's middle.
  EXPECT_GT(substeps * dt, 0.25);
  const double drop = 0.5 * 9.81 * std::pow(substeps * dt, 2);
  for (const uint32_t v : {0u, n * n / 2, n * n - 1}) {
    EXPECT_EQ(x[v].x, float(v % n));
    EXPECT_NEAR(x[v].y, double(v / n) - drop, 6e-4) << v;
    EXPECT_EQ(x[v].z, 0.0f);
  }
}

}  // namespace
}  // namespace weft_tests
