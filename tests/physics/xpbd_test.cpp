// XPBD against an independent double reference, the implicit step of one spring, and what it must
// keep: momentum, its order, its stability.
#include "reference/networks.h"
#include "reference/random.h"
#include "reference/refusals.h"
#include "reference/sheets.h"
#include "reference/xpbd.h"

#include <algorithm>
#include <numbers>

namespace weft_tests {
namespace {

weft::WorldDesc xpbd_world(weft::Precision precision = weft::Precision::float64) {
  weft::WorldDesc desc = plain_world(precision);
  desc.integrator = weft::Integrator::xpbd;
  return desc;
}

double furthest(const std::vector<Vec>& a, const std::vector<Vec>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
  return most;
}

struct Case {
  const char* name;
  uint32_t rows, columns;
  weft::Stencil stencil;
  std::vector<int> ladder;
  double damping = 0, drag = 0;
};

class XpbdGrid : public testing::TestWithParam<Case> {
 protected:
  const Case& c = GetParam();
  static constexpr double dt = 0.004;

  Sheet sheet() const {
    Sheet s;
    s.rows = c.rows;
    s.columns = c.columns;
    s.stencil = c.stencil;
    s.stiffness = 800;
    s.pins = {0, c.columns - 1};
    s.noise = 0.02;
    return s;
  }
  /// Pins glide along x.
  reference::Xpbd expected() const {
    const Sheet s = sheet();
    reference::System system = s.system();
    system.gravity = {0, 1, -9.81};
    system.drag = c.drag;
    system.spring_damping = c.damping;
    const std::vector<Vec> from = system.positions;
    system.pin_motion = [from](uint32_t p, double t) { return from[p] + Vec{0.3 * t, 0, 0}; };
    system.velocities.assign(s.count(), {0.1, 0, 0.2});
    return {system,
            reference::links_of_grid(int(c.rows), int(c.columns), offsets(c.stencil), s.stiffness,
                                     1, 1, c.ladder),
            dt};
  }
  std::vector<Vec> actual(weft::Precision precision, int steps) const {
    const Sheet s = sheet();
    weft::WorldDesc desc = xpbd_world(precision);
    desc.gravity = {0, 1, -9.81};
    std::fill(std::begin(desc.ladder), std::end(desc.ladder), uint8_t(0));
    std::copy(c.ladder.begin(), c.ladder.end(), desc.ladder);
    TestWorld test(desc);
    weft::ClothDesc cloth;
    cloth.velocity = {0.1, 0, 0.2};
    cloth.drag = c.drag;
    cloth.spring_damping = c.damping;
    const std::vector<weft::double3> x = to_weft(s.start());
    const std::vector<weft::Pin> pins{{0, 0}, {c.columns - 1, 0}};
    const std::vector<weft::PinMotion> motions{{{0.3, 0, 0}, {0, 0, 0}, 0}};
    cloth.positions = weft::View<weft::double3>(x);
    cloth.pins = pins;
    cloth.motions = motions;
    const weft::ClothId id = test.add(s.grid(), cloth);
    test.step(dt, steps);
    return test.positions(id);
  }
};

TEST_P(XpbdGrid, MovesSpringsOneAfterTheOther) {
  reference::Xpbd wanted = expected();
  wanted.steps(60);
  EXPECT_LT(furthest(actual(weft::Precision::float64, 60), wanted.positions()), 1e-11);
  EXPECT_LT(furthest(actual(weft::Precision::float32, 60), wanted.positions()), 2e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Stencils, XpbdGrid,
    testing::Values(Case{"seed12", 7, 9, weft::Stencil::seed12, {}},
                    Case{"classic12", 9, 6, weft::Stencil::classic12, {}},
                    Case{"quad4", 5, 5, weft::Stencil::quad4, {}},
                    Case{"tri6", 4, 11, weft::Stencil::tri6, {}},
                    Case{"long_rows", 4, 75, weft::Stencil::classic12, {}},
                    Case{"long_columns", 70, 3, weft::Stencil::seed12, {}},
                    Case{"a_row", 1, 37, weft::Stencil::classic12, {}},
                    Case{"dragged", 6, 8, weft::Stencil::classic12, {}, 0, 0.02},
                    Case{"damped", 8, 7, weft::Stencil::classic12, {}, 0.05, 0.01},
                    Case{"ladder_8_4", 21, 26, weft::Stencil::classic12, {8, 4}},
                    Case{"ladder_5_3_2", 17, 40, weft::Stencil::seed12, {5, 3, 2}, 0.05}),
    [](const auto& info) { return std::string(info.param.name); });

class Xpbd : public BothPrecisions {};
INSTANTIATE_TEST_SUITE_P(Precisions, Xpbd, both_precisions(), precision_name);

/// One spring from an anchor along a line: each substep is the implicit Euler step, m (x - y)/h^2 =
/// -k (x - L) - b (x - x_n)/h, in closed form.
TEST_P(Xpbd, OneSpringTakesTheImplicitStep) {
  for (const double damping : {0.0, 3.0}) {
    AnchoredMass mass;
    mass.stiffness = 400;
    mass.mass = 0.7;
    mass.start = {1, 0, 0};
    mass.velocity = {2, 0, 0};
    mass.spring_damping = damping;
    TestWorld test(xpbd_world(GetParam()));
    const weft::ClothId id = mass.add_to(test);
    const double h = 0.01;
    double x = 1, v = 2;
    for (int n = 0; n < 50; ++n) {
      test.step(h);
      const double y = x + h * v;
      const double next =
          (0.7 * y / (h * h) + 400 * 1.0 + damping * x / h) / (0.7 / (h * h) + 400 + damping / h);
      v = (next - x) / h;
      x = next;
      expect_near(test.position(id, 1), {x, 0, 0}, tolerance(GetParam(), 1));
      expect_near(test.velocities(id)[1], {v, 0, 0}, 100 * tolerance(GetParam(), 1));
    }
  }
}

/// Half the step, half the error of a spring that swings (order 1).
TEST(XpbdOrder, IsOne) {
  const double omega = std::sqrt(100.0), end = 0.5;
  double before = 0;
  for (const int steps : {400, 800, 1600, 3200}) {
    AnchoredMass mass;
    mass.start = {1.01, 0, 0};
    mass.rest_length = 1;
    TestWorld test(xpbd_world());
    const weft::ClothId id = mass.add_to(test);
    test.step(end / steps, steps);
    // The network's rest shape is the start: its spring's rest length is given.
    const double error = std::abs(test.position(id, 1).x - (1 + 0.01 * std::cos(omega * end)));
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / error), 1, 0.05) << steps;
    }
    before = error;
  }
}

/// A crumpled free network in float64: what springs do to each other adds up to nothing.
TEST(XpbdMomentum, IsKept) {
  reference::SplitMix random(4);
  NetworkParts parts;
  parts.masses.clear();
  for (int i = 0; i < 60; ++i) {
    parts.positions.push_back(Vec{0.3 * i, 0, 0} + random.noise(1));
    parts.masses.push_back(1 + 0.1 * i);
    parts.velocities.push_back(random.noise(2));
    for (int j = std::max(0, i - 4); j < i; ++j) {
      parts.springs.push_back({uint32_t(j), uint32_t(i), 50.0 + i, 0.4});
    }
  }
  TestWorld test(xpbd_world());
  weft::ClothDesc cloth;
  cloth.spring_damping = 0.2;
  const weft::ClothId id = add_network(test, parts, cloth);
  const auto momentum = [&] {
    Vec sum;
    const std::vector<Vec> v = test.velocities(id);
    for (size_t i = 0; i < v.size(); ++i) sum += parts.masses[i] * v[i];
    return sum;
  };
  test.step(0.003);
  const Vec before = momentum();
  test.step(0.003, 300);
  EXPECT_GT(length(before), 1);
  EXPECT_LT(length(momentum() - before), 1e-10);
}

/// Of a chain that hangs from its end, what one pass leaves of its stretch: a quarter at half the
/// step.
TEST(XpbdStretch, GoesAsTheSquareOfTheStep) {
  double before = 0;
  for (const uint32_t substeps : {10u, 20u, 40u}) {
    NetworkParts parts;
    parts.masses = {0.001};
    parts.pins = {0};
    for (uint32_t i = 0; i < 33; ++i) {
      parts.positions.push_back({0, 0, -double(i) / 32});
      if (i > 0) parts.springs.push_back({i - 1, i, 1e7, 1.0 / 32});
    }
    weft::WorldDesc desc = xpbd_world();
    desc.gravity = {0, 0, -9.81};
    desc.substeps = substeps;
    TestWorld test(desc);
    weft::ClothDesc cloth;
    cloth.drag = 0.01;
    const weft::ClothId id = add_network(test, parts, cloth);
    test.step(1.0 / 60, 240);
    const double stretch = -test.position(id, 32).z - 1;
    ASSERT_GT(stretch, 0);
    if (before > 0) {
      EXPECT_NEAR(before / stretch, 4, 0.2) << substeps;
    }
    before = stretch;
  }
}

/// float32 loses no gravity to rounding, however short the substeps are: after n of them a free
/// sheet has fallen by g h^2 n(n + 1)/2.
TEST_P(Xpbd, FallsAtAnySubstep) {
  for (const uint32_t substeps : {1u, 40u, 640u}) {
    Sheet sheet;
    weft::WorldDesc desc = xpbd_world(GetParam());
    desc.gravity = {0, 0, -9.81};
    desc.substeps = substeps;
    TestWorld test(desc);
    const weft::ClothId id = sheet.add_to(test);
    test.step(1.0 / 60, 20);
    const double n = 20.0 * substeps, h = 1.0 / 60 / substeps;
    const double fallen = 9.81 * h * h * n * (n + 1) / 2;
    expect_near(test.positions(id)[63], {1, 1, -fallen}, tolerance(GetParam(), 2));
  }
}

/// What a soft spring corrects in a substep may be below the last bit of a position: it carries all
/// the same, and a sheet beside it has the stretch of its stiffness.
TEST_P(Xpbd, SoftSpringsCarryAtAnySubstep) {
  for (const uint32_t substeps : {10u, 300u, 1000u}) {
    NetworkParts parts;
    parts.positions = {{0, 0, 0}, {0, 0, -1}};
    parts.masses = {1};
    parts.pins = {0};
    parts.springs = {{0, 1, 100, 1}};
    weft::WorldDesc desc = xpbd_world(GetParam());
    desc.gravity = {0, 0, -9.81};
    desc.substeps = substeps;
    TestWorld test(desc);
    weft::ClothDesc cloth;
    cloth.spring_damping = 5;
    const weft::ClothId id = add_network(test, parts, cloth);
    test.step(1.0 / 60, 600);
    EXPECT_NEAR(-1 - test.position(id, 1).z, 0.0981, 5e-4) << substeps;
  }
}

/// Soft grids get no long springs of themselves, which would stiffen them: one of 70 rows sags like
/// the sum of what hangs on each row.
TEST(XpbdLadder, LeavesSoftClothSoft) {
  weft::WorldDesc desc = xpbd_world();
  desc.gravity = {0, -9.81, 0};
  desc.substeps = 60;
  TestWorld test(desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = 70;
  grid.stencil = weft::Stencil::quad4;
  grid.material.stiffness = 50;
  std::vector<weft::Pin> pins;
  for (uint32_t c = 0; c < 70; ++c) pins.push_back({69 * 70 + c});
  weft::ClothDesc cloth;
  cloth.pins = pins;
  cloth.drag = 5.0 / 4900;
  const weft::ClothId id = test.add(grid, cloth);
  test.step(1.0 / 60, 600);
  const double weight = 9.81 / 4900;  // of a vertex
  EXPECT_NEAR(-test.positions(id)[35].y, weight / 50 * 69 * 70 / 2, 0.003);
}

/// Masses of a ratio of 1e6 and stiffnesses of 1e8 in one cloth, at any step.
TEST_P(Xpbd, StandsExtremes) {
  for (const double dt : {1e-4, 1.0 / 30, 1.0}) {
    NetworkParts parts;
    parts.masses.clear();
    reference::SplitMix random(9);
    for (int i = 0; i < 100; ++i) {
      parts.positions.push_back({0.1 * (i % 10), 0.1 * (i / 10), 0});
      parts.start.push_back(parts.positions.back() + random.noise(0.05));
      parts.masses.push_back(i % 3 == 0 ? 1e-3 : i % 3 == 1 ? 1 : 1e3);
      const double k = i % 2 == 0 ? 1e-2 : 1e6;
      if (i % 10 > 0) parts.springs.push_back({uint32_t(i - 1), uint32_t(i), k, 0.1});
      if (i >= 10) parts.springs.push_back({uint32_t(i - 10), uint32_t(i), 1e4, 0.1});
    }
    parts.start[5] = parts.start[6];  // a spring of no length
    parts.pins = {0, 9};
    weft::WorldDesc desc = xpbd_world(GetParam());
    desc.gravity = {0, 0, -9.81};
    desc.substeps = 4;
    TestWorld test(desc);
    const weft::ClothId id = add_network(test, parts);
    test.step(dt, 200);
    const std::vector<Vec> x = test.positions(id);
    EXPECT_TRUE(all_finite(x)) << dt;
    const double t = 200 * dt, fall = 9.81 * t * (t + dt) / 2;  // of what hangs on nothing
    for (const Vec& p : x) EXPECT_LT(length(p), 1.01 * fall + 3) << dt;
  }
}

TEST(XpbdRefuses, WhatItCannotDo) {
  const auto refused = [](auto change, const std::vector<std::string>& words) {
    TestWorld test;
    weft::WorldDesc desc = xpbd_world();
    change(desc);
    expect_refusal(test, test.context().create_world(desc).status(), words);
  };
  refused([](auto& d) { d.form = weft::Form::position; }, {"form is position", "summed"});
  refused([](auto& d) { d.evaluation = weft::Evaluation::scatter; },
          {"evaluation is scatter", "automatic"});
  refused([](auto& d) { d.ladder[0] = 1; }, {"ladder[0] is 1"});
  refused([](auto& d) { d.ladder[0] = 4, d.ladder[1] = 8; }, {"ladder[1] is 8"});
  refused([](auto& d) { d.integrator = weft::Integrator(7); }, {"integrator"});

  TestWorld test(xpbd_world());
  NetworkParts parts;
  parts.masses = {1};
  for (uint32_t i = 0; i <= 200; ++i) {
    parts.positions.push_back({0.1 * i, 1.0 * (i == 0), 0});
    if (i > 0) parts.springs.push_back({0, i, 10, 1});
  }
  EXPECT_THROW(add_network(test, parts), std::runtime_error);
  EXPECT_NE(test.log().find("vertex 0 has 200 springs"), std::string::npos) << test.log();
}

/// A substep of any length is stable: nothing bounds it, and `max_substeps` drops no time.
TEST(XpbdSubsteps, AreBoundByNothing) {
  Sheet sheet;
  sheet.stiffness = 1e9;
  weft::WorldDesc desc = xpbd_world();
  desc.substeps = 0;
  desc.max_substeps = 5;
  desc.gravity = {0, 0, -9.81};
  TestWorld test(desc);
  sheet.add_to(test);
  EXPECT_EQ(test.world().stability().dt_bound, infinity);
  EXPECT_LE(test.take(test.world().substeps(0.5)), 5u);
  test.step(0.5);
  EXPECT_EQ(test.world().time(), 0.5);
}

/// Lagged drag does bound the step: then the rest of it is dropped, as with Verlet.
TEST(XpbdSubsteps, OfLaggedDragDropTime) {
  Sheet sheet;
  sheet.vertex_mass = 1e-4;
  weft::WorldDesc desc = xpbd_world();
  desc.substeps = 0;
  desc.max_substeps = 8;
  TestWorld test(desc);
  weft::ClothDesc cloth;
  cloth.drag = 0.5;
  cloth.drag_model = weft::DragModel::lagged;
  sheet.add_to(test, cloth);
  test.step(1.0 / 60);
  EXPECT_GT(test.world().stats().time_dropped, 0);
  desc.substeps = 2;
  TestWorld fixed(desc);
  sheet.add_to(fixed, cloth);
  EXPECT_EQ(fixed.world().step(1.0 / 60), weft::Status::unstable_step);
  EXPECT_NE(fixed.log().find("the drag of vertex"), std::string::npos) << fixed.log();
}

/// The length of a chain counts along it: a thin strap needs no more than a wide one.
TEST(XpbdSubsteps, OfAStrapAreNotThoseOfItsWidth) {
  const auto substeps = [](double width) {
    weft::WorldDesc desc = xpbd_world();
    desc.substeps = 0;
    desc.gravity = {0, -9.81, 0};
    TestWorld test(desc);
    weft::GridDesc grid;
    grid.rows = 41;
    grid.columns = 3;
    grid.height = 2;
    grid.width = width;
    grid.material.stiffness = 1e5;
    test.add(grid, {});
    return test.take(test.world().substeps(1.0 / 60));
  };
  EXPECT_EQ(substeps(0.1), substeps(0.02));
  EXPECT_LT(substeps(0.1), 20u);
}

}  // namespace
}  // namespace weft_tests
