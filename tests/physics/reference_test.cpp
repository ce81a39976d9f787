// The reference itself against closed forms and published numbers, so that the other tests may
// rely on it.
#include "reference/closed_forms.h"
#include "reference/eigenvalue.h"
#include "reference/grid.h"
#include "reference/random.h"
#include "reference/verlet.h"

#include <gtest/gtest.h>

namespace reference {
namespace {

System anchored(double x0) {
  System system;
  system.positions = {{0, 0, 0}, {x0, 0, 0}};
  system.masses = {1, 1};
  system.pins = {0};
  system.springs = {{0, 1, 100, 1}};
  return system;
}

TEST(Reference, SplitMixGivesThePublishedNumbers) {
  SplitMix random(1);
  EXPECT_NEAR(random.uniform(), 0.56656158, 5e-9);
  EXPECT_NEAR(random.uniform(), 0.74578176, 5e-9);
  EXPECT_NEAR(random.uniform(), 0.97100275, 5e-9);
}

TEST(Reference, OscillatorAgreesWithItsClosedForm) {
  for (double dt : {0.001, 0.01, 0.1, 0.19}) {
    Verlet exact(anchored(1.25), dt);
    exact.steps(1000);
    EXPECT_NEAR(exact.positions()[1].x, 1 + oscillator(0.25, 0, 10, dt, 1000), 1e-11);
    System lagged = anchored(1.25);
    lagged.taylor_start = false;
    Verlet naive(lagged, dt);
    naive.steps(1000);
    EXPECT_NEAR(naive.positions()[1].x, 1 + oscillator_lagged_start(0.25, 10, dt, 1000), 1e-11);
  }
  EXPECT_NEAR(1 + oscillator(0.25, 0, 10, 0.05, 1000), 0.773378131542606, 1e-13);
  EXPECT_NEAR(1 + oscillator_lagged_start(0.25, 10, 0.05, 1000), 0.746123127431, 1e-12);
}

TEST(Reference, InitialVelocityAgreesWithItsClosedForm) {
  System system = anchored(1.25);
  system.velocities = {{}, {0.7, 0, 0}};
  Verlet verlet(system, 0.01);
  EXPECT_NEAR(verlet.velocity(1).x, 0.7, 1e-13);
  verlet.steps(500);
  EXPECT_NEAR(verlet.positions()[1].x, 1 + oscillator(0.25, 0.7, 10, 0.01, 500), 1e-11);
}

TEST(Reference, InvariantOfTheOscillatorIsExact) {
  const double dt = 0.05, w2 = 100;
  Verlet verlet(anchored(1.25), dt);
  double before = 0.25;
  for (int n = 0; n < 1000; ++n) {
    verlet.step();
    const double u = verlet.positions()[1].x - 1, v = (u - before) / dt;
    ASSERT_NEAR(v * v + w2 * u * before, 5.859375, 1e-11);
    before = u;
  }
}

TEST(Reference, DragAgreesWithItsClosedForms) {
  for (bool central : {false, true}) {
    System system = anchored(1.25);
    system.drag = 2;
    system.central_drag = central;
    Verlet verlet(system, 0.01);
    verlet.steps(100);
    const double expected = central ? central_drag_oscillator(0.25, 10, 0.02, 0.01, 100)
                                    : lagged_drag_oscillator(0.25, 10, 0.02, 0.01, 100);
    EXPECT_NEAR(verlet.positions()[1].x, 1 + expected, 1e-12);
  }
  EXPECT_NEAR(1 + lagged_drag_oscillator(0.25, 10, 0.02, 0.01, 100), 0.918813982507019, 1e-13);
}

TEST(Reference, SpringDampingOnALineIsDragTowardsAnAnchor) {
  System along = anchored(1.25);
  along.spring_damping = 2;
  System drag = anchored(1.25);
  drag.drag = 2;
  drag.central_drag = false;
  Verlet a(along, 0.01), b(drag, 0.01);
  a.steps(200);
  b.steps(200);
  EXPECT_NEAR(a.positions()[1].x, b.positions()[1].x, 1e-13);
}

TEST(Reference, PinMotionsAgreeWithTheirClosedForms) {
  // The spring is longer than the amplitude V/w = 5 of the swing, so that it never turns round.
  System system = anchored(20);
  system.springs[0].rest = 20;
  system.pin_motion = [](uint32_t, double t) { return Vec{50 * t, 0, 0}; };
  Verlet moved(system, 0.01);
  moved.steps(1000);
  EXPECT_NEAR(moved.positions()[1].x - 19, 503.352768584427, 1e-9);
  EXPECT_NEAR(dragged_by_pin(1, 50, 10, 0.01, 1000), 503.352768584427, 1e-11);
  system = anchored(1);
  system.pin_motion = [](uint32_t, double t) { return Vec{0.3 * std::sin(7 * t), 0, 0}; };
  Verlet driven(system, 0.01);
  driven.steps(1000);
  EXPECT_NEAR(driven.positions()[1].x, 1.648574621650, 1e-11);
  EXPECT_NEAR(driven_by_pin(1, 0.3, 7, 10, 0.01, 1000), 1.648574621650, 1e-11);
}

TEST(Reference, ForceVectorsAgreeWithTheTable) {
  const std::vector<Vec> rest = grid_positions(8, 8);
  System system;
  system.positions = rest;
  system.masses.assign(64, 0.01);
  system.springs = grid_springs_at_rest(8, 8, seed12(), 1000, rest);
  SplitMix random(1);
  for (Vec& x : system.positions) x += random.noise(0.01);
  EXPECT_NEAR(elastic_energy(system.springs, system.positions), 9.97053246734413, 1e-12);
  std::vector<Vec> f(64);
  add_spring_forces(system.springs, system.positions, f);
  EXPECT_NEAR(f[0].x, -15.62740608914, 1e-10);
  EXPECT_NEAR(f[27].y, 14.26781493761, 1e-10);
  EXPECT_NEAR(f[63].z, 2.348944939583, 1e-11);
  system.gravity = {0, -9.81, 0};
  Verlet verlet(system, 6.454972243679e-4);
  verlet.steps(100);
  EXPECT_NEAR(verlet.positions()[27].y, 0.400310658248, 1e-11);
  EXPECT_NEAR(verlet.positions()[0].x, -0.002775006477, 1e-11);
}

TEST(Reference, GridHasThePublishedNumberOfSprings) {
  EXPECT_EQ(2 * grid_springs(32, 32, seed12(), 1).size(), 11412u);
  EXPECT_EQ(2 * grid_springs(32, 32, classic12(), 1).size(), 11652u);
  EXPECT_EQ(2 * grid_springs(32, 32, tri6(), 1).size(), 5890u);
}

TEST(Reference, LargestEigenvalueAgreesWithTheTable) {
  const std::vector<double> unit(64, 1.0);
  EXPECT_NEAR(largest_laplacian_eigenvalue(grid_springs(8, 8, seed12(), 1), unit, 40000),
              15.7674283198, 1e-8);
  EXPECT_NEAR(edge_bound(grid_springs(8, 8, seed12(), 1), unit), 0.408248290, 1e-9);
}

}  // namespace
}  // namespace reference
