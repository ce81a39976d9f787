// Two particles, and heaps of them, that touch: against an independent computation in double.
#include "reference/networks.h"
#include "reference/particle_contact.h"
#include "reference/random.h"

#include <tuple>

namespace weft_tests::self_collision_pair {
namespace {

using reference::ContactParticle;

constexpr double dt = 1.0 / 64;

class SelfCollisionPair
    : public testing::TestWithParam<std::tuple<weft::Precision, weft::Form, weft::PairSearch>> {
 protected:
  const weft::Precision precision = std::get<0>(GetParam());
  const weft::Form form = std::get<1>(GetParam());

  weft::WorldDesc world(weft::double3 gravity = {0, 0, 0}) const {
    weft::WorldDesc desc = plain_world(precision);
    desc.form = form;
    desc.gravity = gravity;
    return desc;
  }
  /// Everything is found: the whole of each cell, and eight grids of cells of twice the distance.
  weft::SelfCollisionDesc contact(double distance, double friction = 0) const {
    weft::SelfCollisionDesc desc;
    desc.search = std::get<2>(GetParam());
    desc.distance = distance;
    desc.friction = friction;
    desc.cell = 2 * distance;
    return desc;
  }
  /// In m, of positions about 1 m from the origin.
  double rounding() const { return precision == weft::Precision::float64 ? 1e-14 : 1e-6; }
};

/// Particles of one cloth, whose rest shape is spread out so that none is excluded.
weft::ClothId add_contact_particles(TestWorld& test, const std::vector<ContactParticle>& all,
                                    uint32_t cloth, std::vector<weft::Spring> springs = {}) {
  NetworkParts parts;
  parts.springs = std::move(springs);
  weft::ClothDesc desc;
  for (const ContactParticle& p : all) {
    if (p.cloth != cloth) continue;
    const auto index = uint32_t(parts.positions.size());
    parts.positions.push_back(p.rest);
    parts.start.push_back(p.x);
    parts.velocities.push_back((1 / dt) * p.d);
    parts.masses.push_back(p.inverse_mass > 0 ? 1 / p.inverse_mass : 1);
    if (p.inverse_mass == 0) parts.pins.push_back(index);
    desc.collision_distance = p.distance;
  }
  return add_network(test, parts, desc);
}

constexpr Vec rests[] = {{0, 0, 0}, {5, 0, 0}};

/// Two particles whose ways in a substep are `d`, after it and after another one.
struct AfterContact {
  Vec x[2], d[2];  ///< d: of the second substep
};
AfterContact step_twice(TestWorld& test, const std::vector<ContactParticle>& all) {
  const weft::ClothId cloth = add_contact_particles(test, all, 0);
  AfterContact after;
  test.step(dt);
  const std::vector<Vec> first = test.positions(cloth, 2);
  test.step(dt);
  const std::vector<Vec> second = test.positions(cloth, 2);
  for (size_t i = 0; i < 2; ++i) {
    after.x[i] = first[i];
    after.d[i] = second[i] - first[i];
  }
  return after;
}

struct Case {
  const char* name;
  ContactParticle a, b;
  double friction;
};
const Case cases[] = {
    {"head on", {{0.1, 0.2, 0.3}, {0.01, 0, 0}, 1}, {{0.21, 0.2, 0.3}, {-0.02, 0, 0}, 1}, 0},
    {"masses 1 to 3", {{0, 0, 0}, {0.01, 0.02, 0}, 1}, {{0.06, 0.08, 0.02}, {0, 0, 0}, 1. / 3}, 0},
    {"one pinned", {{0, 0, 0}, {}, 0}, {{0.01, 0.08, -0.05}, {0.01, -0.03, 0.02}, 1}, 0},
    {"the other pinned", {{0.01, 0.08, -0.05}, {0.01, -0.03, 0.02}, 2}, {{0, 0, 0}, {}, 0}, 0},
    {"parting", {{0, 0, 0}, {-0.005, 0.003, 0}, 1}, {{0.05, 0, 0}, {0.01, 0, 0.001}, 1}, 0.3},
    {"slides", {{0, 0, 0}, {0, 0.03, 0}, 1}, {{0.05, 0, 0}, {-0.02, -0.01, 0.03}, 0.5}, 0.4},
    {"sticks", {{0, 0, 0}, {0, 0.002, 0}, 1}, {{0.05, 0, 0}, {-0.02, 0, 0.003}, 0.25}, 0.4},
    {"slides on a pin", {{0, 0, 0}, {}, 0}, {{0.01, 0.07, 0}, {0.03, -0.01, 0.004}, 1}, 0.5},
};

TEST_P(SelfCollisionPair, FollowsTheFormula) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    TestWorld test(world());
    test.check(test.world().set_self_collision(contact(0.1, c.friction)));
    std::vector<ContactParticle> all{c.a, c.b};
    all[1].rest = rests[1];
    const AfterContact after = step_twice(test, all);
    reference::contact_step(all, c.friction);
    for (size_t i = 0; i < 2; ++i) {
      expect_near(after.x[i], all[i].x, rounding());
      if (all[i].inverse_mass == 0) {
        EXPECT_TRUE(same_bits(after.d[i], Vec{})) << "a pin stays";
      } else {
        expect_near(after.d[i], all[i].d, 4 * rounding());
      }
    }
  }
}

TEST_P(SelfCollisionPair, TwoPinsLeaveEachOtherAlone) {
  TestWorld test(world());
  test.check(test.world().set_self_collision(contact(0.1, 0.2)));
  const std::vector<ContactParticle> all{{{0, 0, 0}, {}, 0, 0.1, rests[0]},
                                         {{0.05, 0, 0}, {}, 0, 0.1, rests[1]}};
  const AfterContact after = step_twice(test, all);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(length(after.d[i]), 0);
    EXPECT_NEAR(length(after.x[i] - all[i].x), 0, rounding());
  }
}

/// Also where gravity has them go on together, and deep inside each other.
TEST_P(SelfCollisionPair, AnOverlapAtRestGivesNoSpeed) {
  for (const double depth : {0.01, 0.5, 0.99})
    for (const double gravity : {0.0, -8.0}) {
      TestWorld test(world({0, gravity, 0}));
      test.check(test.world().set_self_collision(contact(0.125, 0.5)));
      std::vector<ContactParticle> all(2);
      all[1].rest = rests[1];
      all[1].x = (1 - depth) * Vec{0, 0.075, 0.1};
      for (ContactParticle& p : all) p.distance = 0.125;
      const weft::ClothId cloth = add_contact_particles(test, all, 0);
      test.step(dt);
      const std::vector<Vec> first = test.positions(cloth, 2);
      EXPECT_NEAR(length(first[1] - first[0]), 0.125, rounding());
      test.step(dt, 20);
      const std::vector<Vec> last = test.positions(cloth, 2);
      expect_near(last[1] - last[0], first[1] - first[0], 100 * rounding());
      EXPECT_NEAR(0.5 * (last[0].y + last[1].y), 0.5 * all[1].x.y + 0.5 * gravity * 441 * dt * dt,
                  2e-4);
    }
}

/// Strictly nearer than `distance`: at it a pair does not touch, and one unit in the last place
/// below it does.
TEST_P(SelfCollisionPair, TouchesBelowTheDistanceOnly) {
  const double distance = 0.25;
  const double below = precision == weft::Precision::float64
                           ? std::nextafter(distance, 0.0)
                           : double(std::nextafterf(float(distance), 0.0f));
  for (int axis = 0; axis < 3; ++axis)
    for (const double apart : {distance, below}) {
      TestWorld test(world());
      test.check(test.world().set_self_collision(contact(distance)));
      std::vector<ContactParticle> all(2);
      all[1].rest = rests[1];
      (axis == 0 ? all[1].x.x : axis == 1 ? all[1].x.y : all[1].x.z) = apart;
      for (ContactParticle& p : all) p.distance = distance;
      const weft::ClothId cloth = add_contact_particles(test, all, 0);
      const uint64_t expected = apart < distance ? 1 : 0;
      EXPECT_EQ(test.take(test.world().near_pairs()).count, expected) << axis << " " << apart;
      EXPECT_EQ(test.take(test.world().contacts()).touching, expected) << axis << " " << apart;
      test.step(dt);
      const std::vector<Vec> x = test.positions(cloth, 2);
      EXPECT_EQ(length(x[0]) > 0, expected == 1) << axis << " " << apart;
    }
}

/// A heap in which each has several partners, unequal masses, pins, and another cloth with another
/// distance among it.
TEST_P(SelfCollisionPair, AHeapFollowsTheFormula) {
  for (const double friction : {0.0, 0.6})
    for (const double gravity : {0.0, -8.0}) {
      SCOPED_TRACE(gravity);
      const Vec fall{0, gravity * dt * dt, 0};
      const double carried = 40 * length(fall);
      reference::SplitMix random(77);
      std::vector<ContactParticle> all(300);
      for (size_t i = 0; i < all.size(); ++i) {
        ContactParticle& p = all[i];
        p.x = random.noise(0.3);
        if (precision == weft::Precision::float32) p.x = reference::through_float(p.x);
        p.d = random.noise(0.01);
        p.inverse_mass = i % 17 == 0 ? 0 : 0.5 + random.uniform();
        if (p.inverse_mass == 0) p.d = {};
        p.cloth = i % 3 == 0;
        p.distance = p.cloth == 0 ? 0.1 : 0.06;
        p.rest = {double(i), 0, 0};
      }
      TestWorld test(world({0, gravity, 0}));
      test.check(test.world().set_self_collision(contact(0.1, friction)));
      const weft::ClothId cloths[] = {add_contact_particles(test, all, 0),
                                      add_contact_particles(test, all, 1)};
      test.step(dt);
      // Verlet begins with half of it.
      reference::contact_step(all, friction, 0.5 * fall, carried);
      size_t next[] = {0, 0};
      const std::vector<Vec> x[] = {test.positions(cloths[0], 200), test.positions(cloths[1], 100)};
      double worst = 0;
      for (const ContactParticle& p : all)
        worst = std::max(worst, length(x[p.cloth][next[p.cloth]++] - p.x));
      EXPECT_LE(worst, 10 * rounding());
      // And what they go on with: another substep.
      test.step(dt);
      reference::contact_step(all, friction, fall, carried);
      const std::vector<Vec> y[] = {test.positions(cloths[0], 200), test.positions(cloths[1], 100)};
      next[0] = next[1] = 0;
      worst = 0;
      for (const ContactParticle& p : all)
        worst = std::max(worst, length(y[p.cloth][next[p.cloth]++] - p.x));
      EXPECT_LE(worst, 100 * rounding());
    }
}

/// Particles that soft springs crowd together, a thousand substeps long: the centre of mass goes on
/// as it began.
TEST_P(SelfCollisionPair, MomentumStays) {
  reference::SplitMix random(4);
  std::vector<ContactParticle> all(150);
  Vec momentum;
  double mass = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    ContactParticle& p = all[i];
    p.x = random.noise(0.25);
    p.d = random.noise(0.002) - 0.004 * p.x;
    p.inverse_mass = 0.5 + random.uniform();
    p.rest = {double(i), 0, 0};
    momentum += (1 / (p.inverse_mass * dt)) * p.d;
    mass += 1 / p.inverse_mass;
  }
  TestWorld test(world());
  test.check(test.world().set_self_collision(contact(0.1, 0.3)));
  std::vector<weft::Spring> springs;
  for (uint32_t i = 0; i < all.size(); ++i) {
    springs.push_back({i, uint32_t((i + 61) % all.size()), 4, 0.01});
  }
  const weft::ClothId cloth = add_contact_particles(test, all, 0, springs);
  const auto centre = [&] {
    const std::vector<Vec> x = test.positions(cloth, uint32_t(all.size()));
    Vec sum;
    for (size_t i = 0; i < x.size(); ++i) sum += (1 / all[i].inverse_mass) * x[i];
    return (1 / mass) * sum;
  };
  const Vec before = centre();
  test.step(dt, 500);
  EXPECT_GT(test.take(test.world().contacts()).touching, 20u) << "or nothing is tried";
  test.step(dt, 500);
  const double exact = precision == weft::Precision::float64 ? 1e-13 : 1e-5;
  expect_near(from_weft(test.mechanics().momentum), momentum, mass * exact);
  expect_near(centre(), before + (1000 * dt / mass) * momentum, 100 * exact);
}

INSTANTIATE_TEST_SUITE_P(
    Every, SelfCollisionPair,
    testing::Combine(both_precisions(), testing::Values(weft::Form::summed, weft::Form::position),
                     testing::Values(weft::PairSearch::complete, weft::PairSearch::staggered)),
    [](const auto& info) {
      return std::string(weft::to_string(std::get<0>(info.param))) +
             (std::get<1>(info.param) == weft::Form::summed ? "_summed" : "_position") +
             (std::get<2>(info.param) == weft::PairSearch::complete ? "_complete" : "_staggered");
    });

}  // namespace
}  // namespace weft_tests::self_collision_pair
