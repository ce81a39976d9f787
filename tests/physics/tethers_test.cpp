// Tethers against a reference in double, closed forms, and what they promise: nobody is further
// from its pin than its rest distance along the surface allows.
#include "reference/effects.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

/// One mass on a slack spring of `rest` m to an anchor at the origin: only the tether holds it.
struct TetheredMass {
  double scale = 1, compliance = 0, mass = 0.5, rest = 1, drag = 0;
  Vec start{0.6, 0, 0}, velocity;
  std::vector<weft::PinMotion> motions;

  weft::ClothId add_to(TestWorld& test) const {
    NetworkParts parts;
    parts.positions = {{0, 0, 0}, start};
    parts.springs = {{0, 1, 0, rest}};
    parts.masses = {mass};
    parts.velocities = {{0, 0, 0}, velocity};
    weft::ClothDesc cloth;
    const std::vector<weft::Pin> pins{{0, motions.empty() ? weft::Pin::fixed : 0}};
    cloth.pins = pins;
    cloth.motions = motions;
    cloth.tether_scale = scale;
    cloth.tether_compliance = compliance;
    cloth.drag = drag;
    return add_network(test, parts, cloth);
  }
};

Vec pin_at(const std::vector<weft::PinMotion>& motions, double t) {
  if (motions.empty()) return {0, 0, 0};
  const weft::PinMotion& m = motions[0];
  return t * from_weft(m.velocity) + std::sin(m.omega * t) * from_weft(m.amplitude);
}

/// The scheme of the scene format, by itself: Verlet, then back onto the sphere, displacement too.
class Reference {
 public:
  Reference(const TetheredMass& of, double step)
      : mass_(of), dt_(step), x_(of.start), d_(step * of.velocity - 0.5 * step * step * gravity) {}
  static constexpr Vec gravity{0, -9.81, 0};

  Vec advance() {
    ++n_;
    d_ += dt_ * dt_ * gravity;
    x_ += d_;
    const Vec away = x_ - pin_at(mass_.motions, n_ * dt_);
    const double r = length(away), limit = mass_.scale * mass_.rest;
    if (r > limit) {
      const double w = 1 / mass_.mass, a = mass_.compliance / (dt_ * dt_);
      const Vec by = (-w / (w + a) * (r - limit) / r) * away;
      x_ += by;
      d_ += by;
    }
    return x_;
  }

 private:
  TetheredMass mass_;
  double dt_;
  Vec x_, d_;
  int n_ = 0;
};

weft::WorldDesc falling_world(weft::Precision precision, weft::Form form = weft::Form::summed) {
  weft::WorldDesc desc = plain_world(precision);
  desc.gravity = to_weft(Reference::gravity);
  desc.form = form;
  return desc;
}

TEST(Tethers, FollowAReferenceInDouble) {
  constexpr double dt = 1.0 / 240;
  weft::PinMotion shaken;
  shaken.velocity = {0.3, 0.1, 0};
  shaken.amplitude = {0, 0.2, 0.4};
  shaken.omega = 7;
  std::vector<TetheredMass> cases(4);
  cases[1].scale = 0.8;
  cases[1].velocity = {0, 3, 1};
  cases[2].compliance = 0.002;
  cases[3].motions = {shaken};
  cases[3].compliance = 1e-4;
  for (const TetheredMass& mass : cases) {
    for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
      TestWorld test(falling_world(weft::Precision::float64, form));
      const weft::ClothId cloth = mass.add_to(test);
      Reference reference(mass, dt);
      for (int n = 0; n < 480; ++n) {
        test.step(dt);
        // A swing multiplies rounding errors of the position form.
        const double within = form == weft::Form::summed ? 1e-11 : 1e-8;
        ASSERT_LT(length(test.position(cloth, 1) - reference.advance()), within) << n;
      }
    }
  }
}

class TethersInBoth : public BothPrecisions {};

TEST_P(TethersInBoth, AMassHangsAtItsLimitAndOneOfComplianceItsWeightLower) {
  for (const double compliance : {0.0, 1e-3, 0.05}) {
    TetheredMass mass;
    mass.compliance = compliance;
    mass.start = {0, -0.9, 0};
    mass.drag = 2;
    TestWorld test(falling_world(GetParam()));
    const weft::ClothId cloth = mass.add_to(test);
    test.step(1.0 / 240, 240 * 20);
    // At rest a step falls by g dt^2/(1 + G/2), G = c dt/m, which the correction takes back.
    const double weight = mass.mass * 9.81 / (1 + 0.5 * mass.drag / (240 * mass.mass));
    EXPECT_NEAR(test.position(cloth, 1).y, -1 - compliance * weight, 2e-6) << compliance;
  }
}

TEST_P(TethersInBoth, ASwingNeverGainsEnergyNorLeavesItsSphere) {
  TetheredMass mass;
  mass.start = {1, 0, 0};
  mass.rest = 1;
  TestWorld test(falling_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  double most = 0;
  for (int n = 0; n < 240 * 20; ++n) {
    test.step(1.0 / 240);
    const Vec x = test.position(cloth, 1), v = test.velocities(cloth)[1];
    ASSERT_LE(length(x), 1 + 1e-6) << n;
    most = std::max(most, 0.5 * dot(v, v) + 9.81 * x.y);
  }
  // One step's fall is all that the order of the scheme can add.
  EXPECT_LT(most, 9.81 / 240 * std::sqrt(2 * 9.81));
}

/// Largest distance from the nearest corner over its distance in steps of the grid.
double longest(const std::vector<Vec>& x, uint32_t n) {
  double most = 0;
  for (uint32_t v = 0; v < n * n; ++v) {
    const double row = v / n, column = v % n;
    const bool left = column <= n - 1 - column;  // the pins are corners of the first row
    const double across = left ? column : n - 1 - column;
    const double straight = std::abs(row - across), slanted = std::min(row, across);
    const double rest = (straight + std::sqrt(2.0) * slanted) / (n - 1);
    if (rest > 0) most = std::max(most, length(x[v] - x[left ? 0 : n - 1]) / rest);
  }
  return most;
}

struct HangingSheet {
  double scale = 1, far = 0, stiffness = 1;
  bool led = false;
};
double longest_in(weft::Precision precision, const HangingSheet& sheet, double seconds) {
  constexpr uint32_t n = 33;
  weft::WorldDesc desc;
  desc.precision = precision;
  TestWorld test(desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.material.stiffness = sheet.stiffness;
  grid.material.mass.value = 0.3;
  weft::PinMotion motion;
  motion.velocity = {0.2, 0, 0};
  motion.amplitude = {0, 0.3, 0.5};
  motion.omega = 9;
  weft::ClothDesc cloth;
  cloth.pose = {{1, 0, 0}, 90, {sheet.far, 0, 0}};
  const std::vector<weft::Pin> pins{{0, sheet.led ? 0 : weft::Pin::fixed},
                                    {n - 1, sheet.led ? 0 : weft::Pin::fixed}};
  cloth.pins = pins;
  cloth.motions = weft::View<weft::PinMotion>(&motion, 1);
  cloth.tether_scale = sheet.scale;
  const weft::ClothId id = test.add(grid, cloth);
  double most = 0;
  for (int frame = 0; frame < 60 * seconds; ++frame) {
    test.step(1.0 / 60);
    most = std::max(most, longest(test.positions(id), n));
  }
  return most;
}

TEST_P(TethersInBoth, ASoftSheetStretchesNoFurtherTowardsItsPinsThanTheyAllow) {
  EXPECT_GT(longest_in(GetParam(), {0}, 2), 3) << "it is soft";
  for (const double scale : {1.0, 1.1, 1.5}) {
    const double most = longest_in(GetParam(), {scale}, 3);
    EXPECT_LE(most, scale * 1.000002) << scale;
    EXPECT_GT(most, scale * 0.9) << scale;
  }
}

TEST_P(TethersInBoth, PinsThatMoveAndFarPlacesChangeNothingOfThat) {
  HangingSheet led;
  led.led = true;
  EXPECT_LE(longest_in(GetParam(), led, 3), 1.000002);
  led.far = 5000;  // its origin follows in whole metres
  EXPECT_LE(longest_in(GetParam(), led, 3), 1.000002);
}

TEST_P(TethersInBoth, CollidersHaveTheLastWord) {
  weft::WorldDesc desc;
  desc.precision = GetParam();
  TestWorld test(desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = 24;
  grid.material.stiffness = 5;
  weft::ClothDesc cloth;
  cloth.pose = {{1, 0, 0}, 90, {0, 0, 0}};
  const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {23, weft::Pin::fixed}};
  cloth.pins = pins;
  cloth.tether_scale = 0.9;
  const weft::ClothId id = test.add(grid, cloth);
  add_body(test, Body::sphere, {0.5, -0.05, 0.4}, 0.25, 0.3);
  bool touched = false;
  for (int frame = 0; frame < 120; ++frame) {
    test.step(1.0 / 60);
    for (const Vec p : test.positions(id)) {
      const double r = length(p - Vec{0.5, -0.3, 0.4});
      ASSERT_GT(r, 0.25 - 1e-5) << frame;
      touched |= r < 0.25 + 1e-5;
    }
  }
  EXPECT_TRUE(touched);
}

INSTANTIATE_TEST_SUITE_P(Precisions, TethersInBoth, both_precisions(), precision_name);

TEST(Tethers, TakeBackWhoIsOutsideWithoutSpeed) {
  for (const int substeps : {1, 10, 100}) {
    weft::WorldDesc desc;
    desc.gravity = {0, 0, 0};
    desc.precision = weft::Precision::float64;
    desc.substeps = uint32_t(substeps);
    TestWorld test(desc);
    TetheredMass mass;
    mass.start = {1.1, 0, 0};
    mass.velocity = {0, 0.5, 0};  // along the sphere: stays
    const weft::ClothId cloth = mass.add_to(test);
    test.step(1.0 / 60);
    EXPECT_NEAR(length(test.position(cloth, 1)), 1, 1e-12) << substeps;
    EXPECT_NEAR(length(test.velocities(cloth)[1]), 0.5, 0.01) << substeps;
  }
}

TEST(Tethers, ShorterThanTheClothMakeNoEnergy) {
  const auto energy = [](double scale) {
    TestWorld test;
    weft::GridDesc grid;
    grid.rows = grid.columns = 33;
    grid.stencil = weft::Stencil::classic12;
    grid.material.stiffness = 1000;
    grid.material.mass.value = 0.3;
    weft::ClothDesc cloth;
    cloth.pose = {{1, 0, 0}, 90, {0, 0, 0}};
    const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {32, weft::Pin::fixed}};
    cloth.pins = pins;
    cloth.drag = 2e-5;
    cloth.tether_scale = scale;
    test.add(grid, cloth);
    double most = 0;
    for (int frame = 0; frame < 60; ++frame) {
      test.step(1.0 / 60);
      most = std::max(most, test.mechanics().kinetic);
    }
    return most;
  };
  EXPECT_LT(energy(1), 2);
  // What the shortened springs hold: half k (0.02 l)^2 of six thousand, 1.2 J.
  EXPECT_LT(energy(0.98), 5);
}

/// A pin at constant speed that stops: what it dragged along flies on towards it, as fast.
TEST_P(TethersInBoth, WhatAMovingPinDragsHasItsSpeed) {
  constexpr double dt = 1.0 / 64, speed = 2;
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const Vec way : {Vec{1, 0, 0}, Vec{0, -1, 0}, Vec{0, 0, 1}, across}) {
      weft::WorldDesc desc = plain_world(GetParam());
      desc.form = form;
      TestWorld test(desc);
      TetheredMass mass;
      mass.start = -1.0 * way;
      const weft::ClothId cloth = mass.add_to(test);
      const uint32_t pin[] = {0};
      for (int n = 1; n <= 8; ++n) {
        const weft::double3 to = to_weft(n * speed * dt * way);
        test.check(test.world().move_pins(cloth, {pin, 1}, weft::View<weft::double3>(&to, 1)));
        test.step(dt);
        expect_near(test.position(cloth, 1), (n * speed * dt - 1) * way, 1e-5);
      }
      for (int n = 9; n <= 16; ++n) {
        test.step(dt);
        expect_near(test.position(cloth, 1), (n * speed * dt - 1) * way, 1e-4);
      }
    }
}

TEST(Tethers, FollowPinsThatAreAddedAndReleased) {
  TestWorld test;
  weft::GridDesc grid;
  grid.rows = 20;
  grid.columns = 1;
  grid.height = 1.9;
  grid.material.stiffness = 0.5;
  weft::ClothDesc cloth;
  const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}};
  cloth.pins = pins;
  cloth.tether_scale = 1;
  const weft::ClothId rope = test.add(grid, cloth);
  test.step(1.0 / 60, 180);
  EXPECT_LE(length(test.position(rope, 19) - test.position(rope, 0)), 1.9 + 1e-5);
  const uint32_t end[] = {19};
  const weft::double3 up[] = {{0.5, 1.5, 0}};
  test.check(
      test.world().move_pins(rope, weft::View<uint32_t>(end, 1), weft::View<weft::double3>(up, 1)));
  test.step(1.0 / 60, 120);
  for (uint32_t v = 0; v < 20; ++v) {
    const uint32_t pin = v <= 9 ? 0 : 19;
    const double rest = 0.1 * std::abs(double(v) - pin);
    EXPECT_LE(length(test.position(rope, v) - test.position(rope, pin)), rest + 1e-5) << v;
  }
  const uint32_t both[] = {0, 19};
  test.check(test.world().release_pins(rope, weft::View<uint32_t>(both, 2)));
  EXPECT_EQ(test.take(test.world().diagnostics(rope)).count, 1u);
  const Vec before = test.position(rope, 0);
  test.step(1.0 / 60, 60);
  EXPECT_LT(test.position(rope, 0).y, before.y - 3) << "nothing holds it";
}

TEST(Tethers, WhoGetsNoneIsADiagnostic) {
  const auto told = [](std::vector<uint32_t> pins, double scale, double compliance = 0) {
    TestWorld test;
    NetworkParts parts;  // two pieces
    parts.positions = {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {6, 0, 0}};
    parts.springs = {{0, 1, 10, -1}, {2, 3, 10, -1}};
    parts.masses = {1};
    parts.pins = std::move(pins);
    weft::ClothDesc cloth;
    cloth.tether_scale = scale;
    cloth.tether_compliance = compliance;
    const weft::ClothId id = add_network(test, parts, cloth);
    const auto diagnostics = test.take(test.world().diagnostics(id));
    std::string text;
    for (uint32_t k = 0; k < diagnostics.count; ++k) {
      const weft::Diagnostic& d = diagnostics[k];
      text += std::string(d.text) + " @" + std::to_string(d.element);
      EXPECT_NE(test.log().find(d.text), std::string::npos) << "the log was not told";
    }
    test.step(1.0 / 60, 10);
    return text;
  };
  EXPECT_EQ(told({0, 2}, 1), "");
  EXPECT_EQ(told({}, 0), "");
  EXPECT_NE(told({}, 1).find("no pins"), std::string::npos);
  EXPECT_NE(told({0, 1, 2, 3}, 1).find("all of its vertices are pinned"), std::string::npos);
  EXPECT_NE(told({0}, 1).find("2 of its vertices have no tether, the first is 2"),
            std::string::npos);
  EXPECT_NE(told({0}, 0, 1).find("tether_scale is 0"), std::string::npos);
}

TEST(Tethers, RefuseBadNumbersAndChangeNothing) {
  for (const double bad : {-1.0, double(INFINITY), double(NAN)}) {
    for (const bool scale : {true, false}) {
      TestWorld test;
      weft::GridDesc grid;
      weft::ClothDesc cloth;
      cloth.fabric = test.cook(grid);
      (scale ? cloth.tether_scale : cloth.tether_compliance) = bad;
      EXPECT_EQ(test.world().create_cloth(cloth).status(), weft::Status::invalid_argument);
      EXPECT_NE(test.log().find(scale ? "tether_scale" : "tether_compliance"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace weft_tests
