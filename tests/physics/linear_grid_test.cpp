// Springs without rest length are linear: a free R x C grid of them moves in modes
// cos(pi p (r + 1/2)/R) cos(pi q (c + 1/2)/C) at any amplitude.
#include "reference/grid.h"
#include "reference/networks.h"

#include <numbers>

namespace weft_tests::linear_grid {
namespace {

constexpr uint32_t n = 16;
constexpr double k = 10, m = 0.1;
/// 0.9 of the exact limit, 0.063947535167.
const double dt = 0.9 / (std::sqrt(2 * k / m) * std::sin(15 * std::numbers::pi / 32));

double mode(int p, int q, uint32_t r, uint32_t c) {
  const double pi = std::numbers::pi;
  return std::cos(pi * p * (r + 0.5) / n) * std::cos(pi * q * (c + 0.5) / n);
}

double turn(int p, int q, int steps) {
  const double pi = std::numbers::pi, a = std::sin(pi * p / (2 * n)),
               b = std::sin(pi * q / (2 * n));
  return std::cos(2 * steps * std::asin(dt * std::sqrt(k / m * (a * a + b * b))));
}

Vec expected(uint32_t r, uint32_t c, int steps) {
  return {
      5 * mode(1, 0, r, c) * turn(1, 0, steps), 5 * mode(0, 1, r, c) * turn(0, 1, steps),
      2 * mode(3, 2, r, c) * turn(3, 2, steps) + 0.5 * mode(15, 15, r, c) * turn(15, 15, steps)};
}

std::vector<weft::double3> at_start() {
  std::vector<weft::double3> x;
  for (uint32_t r = 0; r < n; ++r)
    for (uint32_t c = 0; c < n; ++c) x.push_back(to_weft(expected(r, c, 0)));
  return x;
}

void expect_modes(TestWorld& test, weft::ClothId cloth, weft::Precision precision) {
  const auto check = [&](int steps) {
    const std::vector<Vec> x = test.positions(cloth);
    for (uint32_t r = 0; r < n; ++r)
      for (uint32_t c = 0; c < n; ++c)
        expect_near(x[r * n + c], expected(r, c, steps), tolerance(precision, 5));
  };
  ASSERT_NEAR(expected(0, 0, 100).z, 0.796795485245, 1e-10);
  ASSERT_NEAR(expected(0, 0, 100).x, 4.974693243236, 1e-10);
  ASSERT_NEAR(expected(0, 0, 1000).z, 0.569927178746, 1e-10);
  ASSERT_NEAR(expected(0, 0, 1000).x, 4.853385818033, 1e-10);
  test.step(dt, 100);
  check(100);
  test.step(dt, 900);
  check(1000);
}

using LinearGrid = BothPrecisions;

TEST_P(LinearGrid, GridMovesInItsModes) {
  const std::vector<weft::double3> start = at_start();
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.stencil = weft::Stencil::quad4;
  grid.material.stiffness = k;
  grid.material.rest_length = 0;
  grid.material.mass.value = m * n * n;
  weft::ClothDesc desc;
  desc.positions = weft::View<weft::double3>(start);
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = test.add(grid, desc);
  expect_modes(test, cloth, GetParam());
}

TEST_P(LinearGrid, NetworkOfTheSameSpringsMovesInItsModes) {
  NetworkParts parts;
  parts.masses = {m};
  for (weft::double3 p : at_start()) parts.positions.push_back(from_weft(p));
  for (const reference::Spring& s : reference::grid_springs(n, n, reference::quad4(), k))
    parts.springs.push_back({s.a, s.b, k, 0});
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_network(test, parts);
  expect_modes(test, cloth, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Precision, LinearGrid, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::linear_grid
