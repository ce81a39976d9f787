// Steps that are too long, change, are zero or are split (HC27, HC28, HC30, HC33).
#include "reference/closed_forms.h"
#include "reference/networks.h"
#include "reference/refusals.h"
#include "reference/sheets.h"

#include <cmath>
#include <functional>

namespace weft_tests {
namespace {

using TimeStep = BothPrecisions;

TEST_P(TimeStep, BeyondTheBoundIsRefusedWithBoundAndRemedy) {
  TestWorld test(plain_world(GetParam()));
  AnchoredMass{}.add_to(test);
  test.step(0.1, 3);
  expect_refused_unchanged(
      test, {"0.2", "2 substeps"}, [&] { return test.world().step(0.202); },
      weft::Status::unstable_step);
  expect_refused_unchanged(
      test, {"0.2"}, [&] { return test.world().substeps(0.202).status(); },
      weft::Status::unstable_step);
  test.step(0.2 * 0.9999);  // the bound itself, not safety * bound, is the limit of a fixed step
}

TEST_P(TimeStep, UnsafeAllowsIt) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.unsafe = true;
  TestWorld test(desc);
  AnchoredMass{}.add_to(test);
  EXPECT_EQ(test.world().step(0.202), weft::Status::ok);
}

TEST_P(TimeStep, AutomaticSubstepsAreTheFewestWithinSafety) {
  for (double safety : {0.9, 0.5, 0.25, 1.0}) {
    weft::WorldDesc desc = plain_world(GetParam());
    desc.substeps = 0;
    desc.safety = safety;
    TestWorld test(desc);
    AnchoredMass{}.add_to(test);  // bound 0.2
    for (double dt : {0.01, 0.0999 * safety, 0.17, 0.21, 1.03, 2.01}) {
      const uint32_t expected = uint32_t(std::ceil(dt / (safety * 0.2)));
      EXPECT_EQ(test.take(test.world().substeps(dt)), expected) << safety << ' ' << dt;
      const uint64_t before = test.world().stats().steps;
      test.step(dt);
      EXPECT_EQ(test.world().stats().substeps_last, expected);
      EXPECT_EQ(test.world().stats().steps - before, expected);
      EXPECT_NEAR(test.world().stats().dt_last, dt / expected, 1e-15);
    }
    EXPECT_EQ(test.world().stats().substeps_most, uint32_t(std::ceil(2.01 / (safety * 0.2))));
  }
}

TEST_P(TimeStep, FrameHitchOfTwoSecondsIsSubdivided) {
  weft::WorldDesc desc;
  desc.precision = GetParam();
  TestWorld test(desc);
  Sheet sheet;
  sheet.pins = {56, 63};
  const weft::ClothId cloth = sheet.add_to(test);
  test.step(1.0 / 60);
  test.step(2);
  const double bound = test.world().stability().dt_bound;
  EXPECT_EQ(test.world().stats().substeps_last, uint32_t(std::ceil(2 / (0.9 * bound))));
  for (Vec x : test.positions(cloth)) {
    ASSERT_TRUE(reference::finite(x));
    ASSERT_LE(length(x), 5);
  }
}

TEST_P(TimeStep, SubstepsAreBitwiseSteps) {
  // dt is a power of two, so that dt/N is exact.
  for (uint32_t n : {2u, 4u, 16u}) {
    weft::WorldDesc whole = plain_world(GetParam());
    whole.gravity = {0, -9.81, 0};
    weft::WorldDesc split = whole;
    split.substeps = n;
    TestWorld a(whole), b(split);
    Sheet sheet;
    sheet.noise = 0.01;
    sheet.pins = {56, 63};
    weft::ClothDesc desc;
    desc.drag = 0.001;
    desc.spring_damping = 0.01;
    sheet.add_to(a, desc);
    sheet.add_to(b, desc);
    const double dt = 1.0 / 2048;
    a.step(dt, int(5 * n));
    b.step(dt * n, 5);
    EXPECT_EQ(a.hash(), b.hash()) << n;
    EXPECT_EQ(a.world().time(), b.world().time());
  }
}

TEST_P(TimeStep, FreeFallIsExactWhenTheStepChanges) {
  for (weft::Form form : {weft::Form::summed, weft::Form::position}) {
    if (form == weft::Form::position && GetParam() == weft::Precision::float32) continue;
    weft::WorldDesc desc = plain_world(GetParam());
    desc.gravity = {0, -9.81, 0};
    desc.form = form;
    TestWorld test(desc);
    const weft::ClothId cloth = add_particles(test, {{0, 0, 0}}, {0, 3, 0});
    double t = 0;
    const double within = GetParam() == weft::Precision::float64 ? 1e-12 : 2e-5;
    for (double dt : {1.0 / 60, 1.0 / 120, 1.0 / 30, 0.001, 0.05})
      for (int n = 0; n < 30; ++n) {
        test.step(dt);
        t += dt;
        const double y = 3 * t - 9.81 * t * t / 2;
        ASSERT_NEAR(test.position(cloth, 0).y, y, within * std::max(1.0, std::abs(y)))
            << "dt " << dt << ", step " << n;
      }
  }
}

TEST_P(TimeStep, ChangedStepFollowsItsRecurrence) {
  // x' = x + d dt_n/dt_o + a dt_n (dt_n + dt_o)/2 on a spring, and with it the wrong forms differ.
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = AnchoredMass{}.add_to(test);
  double u = 0.25, old_dt = 0, d = 0;
  const double steps[] = {0.05, 0.05, 0.02, 0.02, 0.08, 0.01, 0.05, 0.05, 0.03, 0.04};
  for (double dt : steps) {
    if (old_dt == 0) {
      d = 100 * u * dt * dt / 2;  // x0 - x_(-1) of the taylor start
      old_dt = dt;
    }
    d = d * dt / old_dt - 100 * u * dt * (dt + old_dt) / 2;
    u += d;
    old_dt = dt;
    test.step(dt);
    ASSERT_NEAR(test.position(cloth, 1).x, 1 + u, tolerance(GetParam(), 1 + u)) << dt;
  }
}

TEST_P(TimeStep, ZeroIsBitwiseNothing) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -9.81, 0};
  Sheet sheet;
  sheet.noise = 0.01;
  sheet.pins = {0};
  TestWorld paused(desc), running(desc);
  const weft::ClothId cloth = sheet.add_to(paused);
  sheet.add_to(running);
  const uint64_t start = paused.hash();
  paused.step(0, 5);  // before the first step, too
  EXPECT_EQ(paused.hash(), start);
  for (int n = 0; n < 20; ++n) {
    paused.step(5e-4, 3);
    running.step(5e-4, 3);
    const std::vector<Vec> v = paused.velocities(cloth);
    paused.step(0);
    EXPECT_TRUE(same_bits(v[27], paused.velocities(cloth)[27]));
    ASSERT_EQ(paused.hash(), running.hash()) << n;
    EXPECT_EQ(paused.world().time(), running.world().time());
  }
}

TEST_P(TimeStep, ResumingAfterAPauseKeepsThePinsMoving) {
  AnchoredMass mass;
  mass.start = {1, 0, 0};
  mass.motions = {{{0, 0, 0}, {0.3, 0, 0}, 7}};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  for (int n = 0; n < 1000; n += 10) {
    test.step(0.01, 10);
    test.step(0);
  }
  EXPECT_NEAR(test.position(cloth, 1).x, 1.648574621650, tolerance(GetParam(), 1.648574621650));
}

TEST_P(TimeStep, AutomaticSubstepsAreTheFewestAtEveryMultipleOfTheBound) {
  for (const double stiffness : {100.0, 37.0, 3.3}) {
    weft::WorldDesc desc = plain_world(GetParam());
    desc.substeps = 0;
    TestWorld test(desc);
    AnchoredMass mass;
    mass.stiffness = stiffness;
    mass.add_to(test);
    const double limit = desc.safety * test.world().stability().dt_bound;
    for (uint32_t n = 1; n < 3000; ++n) {
      for (const double dt :
           {n * limit, std::nextafter(n * limit, 0.0), std::nextafter(n * limit, 1e9)}) {
        const uint32_t count = test.take(test.world().substeps(dt));
        EXPECT_LE(dt / count, limit) << n;
        if (count > 1) {
          EXPECT_GT(dt / (count - 1), limit) << n;
        }
      }
    }
  }
}

TEST_P(TimeStep, WhatIsSetBetweenPrepareAndTheFirstStepCountsInIt) {
  using Set = std::function<void(TestWorld&, weft::ClothId)>;
  const std::vector<weft::VertexForce> force{{0, {0, 0.3, 0}}, {3, {0.2, 0, 0}}};
  const std::vector<uint32_t> pin{0};
  const Set all[] = {
      [](TestWorld& t, weft::ClothId) {
        t.check(t.world().set_gravity({1, -3, 2}));
      },
      [](TestWorld& t, weft::ClothId) {
        t.check(t.world().set_wind({{2, 9, 4}}));
      },
      [](TestWorld& t, weft::ClothId) { t.check(t.world().clear_wind()); },
      [&](TestWorld& t, weft::ClothId id) { t.check(t.world().set_forces(id, force)); },
      [&](TestWorld& t, weft::ClothId id) { t.check(t.world().set_forces(id, {})); },
      [&](TestWorld& t, weft::ClothId id) { t.check(t.world().release_pins(id, pin)); },
  };
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const Set& set : all) {
      weft::WorldDesc desc = plain_world(GetParam());
      desc.form = form;
      desc.gravity = {0, -10, 0};
      desc.unsafe = true;
      const std::vector<weft::VertexForce> first{{7, {0, 0, 1}}};
      const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {5, weft::Pin::fixed}};
      weft::ClothDesc cloth;
      cloth.forces = first;
      cloth.pins = pins;
      cloth.velocity = {0.3, 0, 1};
      weft::GridDesc grid;
      grid.rows = 5;
      grid.columns = 6;
      grid.material.stiffness = 2;
      TestWorld prepared(desc), at_once(desc);
      const weft::ClothId a = prepared.add(grid, cloth), b = at_once.add(grid, cloth);
      for (TestWorld* t : {&prepared, &at_once}) t->check(t->world().set_wind({{-3, 1, 2}}));
      prepared.check(prepared.world().prepare(0.01));
      prepared.positions(a);
      set(prepared, a);
      set(at_once, b);
      prepared.step(0.01, 3);
      at_once.step(0.01, 3);
      EXPECT_EQ(prepared.hash(), at_once.hash()) << (&set - all);
    }
}

TEST_P(TimeStep, GravitySetAfterPrepareMovesTheFirstStepByHalfOfIt) {
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_particles(test, {{0, 0, 0}});
  test.check(test.world().prepare(0.1));
  test.check(test.world().set_gravity({0, -10, 0}));
  test.step(0.1);
  EXPECT_NEAR(test.position(cloth, 0).y, -0.05, 1e-7);  // g dt^2/2, not g dt^2
}

INSTANTIATE_TEST_SUITE_P(Precision, TimeStep, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
