// Forces of every way to add them up: against an independent sum in double, against every spring
// once, and the errors that their precision makes (hard cases 2.9).
#include "reference/each_once.h"
#include "reference/networks.h"
#include "reference/sheets.h"

#include <cmath>

namespace weft_tests::scatter {
namespace {

weft::WorldDesc world_of(weft::Accumulate accumulate, weft::Precision precision,
                         double fixed8_range = 1) {
  weft::WorldDesc desc = plain_world(precision);
  desc.evaluation = weft::Evaluation::scatter;
  desc.accumulate = accumulate;
  desc.deterministic = accumulate != weft::Accumulate::atomic;
  desc.fixed8_range = fixed8_range;
  return desc;
}

constexpr uint32_t n = 16;
constexpr double h = 1.0 / (n - 1);

/// The 16 x 16 sheet of hard cases 2.9 around the origin, its positions rounded to float first.
Sheet noisy_sheet(double noise) {
  Sheet sheet;
  sheet.rows = sheet.columns = n;
  sheet.stiffness = 200;
  sheet.vertex_mass = 1;  // accelerations are forces
  sheet.noise = noise;
  return sheet;
}
std::vector<Vec> positions_of(const Sheet& sheet) {
  std::vector<Vec> x = sheet.start();
  for (Vec& p : x) p = reference::through_float(p - Vec{0.5, 0.5, 0});
  return x;
}

std::vector<Vec> exact_forces(const Sheet& sheet) {
  std::vector<Vec> force(sheet.count());
  reference::add_spring_forces(sheet.system().springs, positions_of(sheet), force);
  return force;
}

std::vector<Vec> forces_of(const Sheet& sheet, const weft::WorldDesc& desc) {
  TestWorld test(desc);
  const std::vector<weft::double3> x = to_weft(positions_of(sheet));
  weft::ClothDesc cloth;
  cloth.positions = weft::View<weft::double3>(x);
  return test.accelerations(test.add(sheet.grid(), cloth));
}

double relative_rms(const std::vector<Vec>& values, const std::vector<Vec>& expected) {
  double difference = 0, size = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    difference += dot(values[i] - expected[i], values[i] - expected[i]);
    size += dot(expected[i], expected[i]);
  }
  return std::sqrt(difference / size);
}

double force_error(double noise, weft::Accumulate mode, double fixed8_range = 1) {
  const Sheet sheet = noisy_sheet(noise);
  return relative_rms(forces_of(sheet, world_of(mode, weft::Precision::float32, fixed8_range)),
                      exact_forces(sheet));
}

/// Each within a factor of 2 of the table's figure.
void expect_as_published(double measured, double published) {
  EXPECT_LE(measured, 2 * published);
  EXPECT_GE(measured, published / 2);
}

TEST(Accumulation, ErrorsAreThePublishedOnesAtTenPercentNoise) {
  expect_as_published(force_error(0.1 * h, weft::Accumulate::native), 6.2e-7);
  expect_as_published(force_error(0.1 * h, weft::Accumulate::float24), 7.1e-6);
  expect_as_published(force_error(0.1 * h, weft::Accumulate::float24_all), 2.3e-4);
  expect_as_published(force_error(0.1 * h, weft::Accumulate::float16), 4.7e-4);
  expect_as_published(force_error(0.1 * h, weft::Accumulate::fixed8, 4), 4.2e-2);
}

TEST(Accumulation, ErrorsAreThePublishedOnesAtOnePercentNoise) {
  expect_as_published(force_error(0.01 * h, weft::Accumulate::native), 6.5e-6);
  expect_as_published(force_error(0.01 * h, weft::Accumulate::float24), 1.0e-5);
  expect_as_published(force_error(0.01 * h, weft::Accumulate::float24_all), 2.2e-3);
  expect_as_published(force_error(0.01 * h, weft::Accumulate::float16), 4.8e-4);
  expect_as_published(force_error(0.01 * h, weft::Accumulate::fixed8, 4), 3.2e-2);
}

/// The sheet hanging from its corners under its weight, damped, in one way to add up.
class Hanging {
 public:
  explicit Hanging(weft::WorldDesc desc, const std::vector<Vec>& start) : test_(hung(desc)) {
    const std::vector<weft::double3> x = to_weft(start);
    const std::vector<weft::Pin> pins{{0}, {n - 1}, {n * n - n}, {n * n - 1}};
    weft::ClothDesc cloth;
    cloth.positions = weft::View<weft::double3>(x);
    cloth.pins = pins;
    cloth.drag = 4 * mass;
    weft::GridDesc grid = noisy_sheet(0).grid();
    grid.material.mass.value = mass * n * n;
    cloth_ = test_.add(grid, cloth);
  }
  std::vector<Vec> after(int steps) {
    test_.step(0.8 * test_.world().stability().dt_bound, steps);
    return test_.positions(cloth_);
  }
  std::vector<Vec> net_forces() {
    std::vector<Vec> f = test_.accelerations(cloth_);
    for (Vec& a : f) a = mass * a;
    return f;
  }
  static constexpr double mass = 0.25 / (n * n);

 private:
  static weft::WorldDesc hung(weft::WorldDesc desc) {
    desc.gravity = {0, 0, -9.81};
    return desc;
  }
  TestWorld test_;
  weft::ClothId cloth_;
};

const std::vector<Vec>& equilibrium() {
  static const std::vector<Vec> x = [] {
    weft::WorldDesc desc = plain_world(weft::Precision::float64);
    return Hanging(desc, positions_of(noisy_sheet(0))).after(60000);
  }();
  return x;
}

TEST(Accumulation, TheEquilibriumIsThePublishedOne) {
  const Vec middle = equilibrium()[(n / 2) * n + n / 2];
  // Minima lie close together; a start that is rounded to float reaches one of them.
  expect_near(middle, {0.0334201966, 0.0334201966, -0.0821158196}, 3e-4);
}

double error_near_equilibrium(weft::Accumulate mode, double fixed8_range = 1) {
  std::vector<Vec> x = equilibrium();
  reference::SplitMix random(1);
  for (Vec& p : x) p = reference::through_float(p + random.noise(1e-4 * h));
  std::vector<Vec> expected(n * n);
  reference::add_spring_forces(noisy_sheet(0).system().springs, x, expected);
  for (Vec& f : expected) f.z -= 9.81 * Hanging::mass;
  for (uint32_t pin : {0u, n - 1, n * n - n, n * n - 1}) expected[pin] = {};
  Hanging sheet(world_of(mode, weft::Precision::float32, fixed8_range), x);
  return relative_rms(sheet.net_forces(), expected);
}

TEST(Accumulation, ErrorsAreThePublishedOnesWhereLargeForcesCancel) {
  expect_as_published(error_near_equilibrium(weft::Accumulate::native), 5.4e-4);
  expect_as_published(error_near_equilibrium(weft::Accumulate::float24), 5.8e-4);
  expect_as_published(error_near_equilibrium(weft::Accumulate::float24_all), 2.2e-1);
  expect_as_published(error_near_equilibrium(weft::Accumulate::float16), 1.2e-2);
  expect_as_published(error_near_equilibrium(weft::Accumulate::fixed8, 4), 4.5);
}

double way_from_equilibrium(weft::Accumulate mode) {
  Hanging sheet(world_of(mode, weft::Precision::float32), equilibrium());
  const std::vector<Vec> x = sheet.after(8000);
  double furthest = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    furthest = std::max(furthest, length(x[i] - equilibrium()[i]));
  }
  return furthest;
}

TEST(Accumulation, EquilibriumErrorsOfSumsAreThePublishedOnes) {
  expect_as_published(way_from_equilibrium(weft::Accumulate::float24), 3.0e-7);
  expect_as_published(way_from_equilibrium(weft::Accumulate::float16), 1.3e-5);
  expect_as_published(way_from_equilibrium(weft::Accumulate::fixed8), 1.0e-2);
  EXPECT_LE(way_from_equilibrium(weft::Accumulate::native), 5e-7);
}

TEST(Accumulation, EightBitsAreUnusableAndSixteenAreNot) {
  EXPECT_GT(force_error(0.1 * h, weft::Accumulate::fixed8), 0.1);  // sums saturate
  EXPECT_LT(force_error(0.1 * h, weft::Accumulate::float16), 1e-3);
  EXPECT_LT(force_error(0.1 * h, weft::Accumulate::native), 1e-5);
}

TEST(Accumulation, ScaledScenesHaveTheSameErrors) {
  // Half floats hold 6e-8 to 65504: a power of two takes forces there, whatever their unit.
  for (const double stiffness : {2e-9, 2e9}) {
    Sheet sheet = noisy_sheet(0.1 * h);
    sheet.stiffness = stiffness;
    const double error = relative_rms(
        forces_of(sheet, world_of(weft::Accumulate::float16, weft::Precision::float32)),
        exact_forces(sheet));
    expect_as_published(error, 4.7e-4);
  }
}

/// Largest error of a component in units of the largest force of a spring.
double error_in_spring_forces(const Sheet& sheet, const std::vector<Vec>& values) {
  const std::vector<Vec> x = positions_of(sheet), expected = exact_forces(sheet);
  double largest = 0, error = 0;
  for (const reference::Spring& s : sheet.system().springs) {
    largest = std::max(largest, s.stiffness * std::abs(length(x[s.b] - x[s.a]) - s.rest));
  }
  for (size_t i = 0; i < values.size(); ++i) {
    error = std::max(error, length(values[i] - expected[i]));
  }
  return error / largest;
}

TEST(Fixed64, IsExactToAMillionthOfTheLargestSpringForce) {
  for (const double noise : {0.3 * h, 0.01 * h, 1e-4 * h}) {
    Sheet sheet = noisy_sheet(noise);
    EXPECT_LE(error_in_spring_forces(sheet, forces_of(sheet, world_of(weft::Accumulate::fixed64,
                                                                      weft::Precision::float64))),
              noise > 1e-3 * h ? 1e-9 : 1e-6)
        << noise;
  }
  // In float the forces themselves are worse than their sum.
  const Sheet sheet = noisy_sheet(0.1 * h);
  EXPECT_LE(error_in_spring_forces(sheet, forces_of(sheet, world_of(weft::Accumulate::fixed64,
                                                                    weft::Precision::float32))),
            1e-5);
  EXPECT_LE(
      relative_rms(forces_of(sheet, world_of(weft::Accumulate::fixed64, weft::Precision::float32)),
                   forces_of(sheet, world_of(weft::Accumulate::native, weft::Precision::float32))),
      1e-6);
}

TEST(Atomic, IsAsExactAsAnyOrderOfAdditions) {
  const Sheet sheet = noisy_sheet(0.1 * h);
  EXPECT_LE(
      relative_rms(forces_of(sheet, world_of(weft::Accumulate::atomic, weft::Precision::float64)),
                   exact_forces(sheet)),
      1e-14);
}

class EachOnce : public BothPrecisions {};

template <class T>
void expect_bits_of_the_gather(weft::Precision precision) {
  Sheet sheet = noisy_sheet(0.2 * h);
  sheet.stencil = weft::Stencil::tri6;
  sheet.rows = 11;
  sheet.columns = 19;
  weft::GridDesc grid = sheet.grid();
  std::vector<reference::Triple<T>> x;
  for (Vec p : positions_of(sheet)) x.push_back({T(p.x), T(p.y), T(p.z)});
  const T across = T(1.0 / (sheet.columns - 1)), down = T(1.0 / (sheet.rows - 1));
  const T rest[3] = {across, down, std::sqrt(across * across + down * down)};
  const auto expected = reference::forces_each_once<T>(x, int(sheet.rows), int(sheet.columns),
                                                       T(grid.material.stiffness.stretch), rest);
  for (weft::Evaluation evaluation : {weft::Evaluation::gather, weft::Evaluation::scatter}) {
    weft::WorldDesc desc = plain_world(precision);
    desc.evaluation = evaluation;
    const std::vector<Vec> f = forces_of(sheet, desc);
    for (size_t i = 0; i < f.size(); ++i) {
      EXPECT_EQ(T(f[i].x), expected[i].x) << i;
      EXPECT_EQ(T(f[i].y), expected[i].y) << i;
      EXPECT_EQ(T(f[i].z), expected[i].z) << i;
    }
  }
}

TEST_P(EachOnce, HasTheBitsOfTheGather) {
  if (GetParam() == weft::Precision::float32) {
    expect_bits_of_the_gather<float>(GetParam());
  } else {
    expect_bits_of_the_gather<double>(GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, EachOnce, both_precisions(), precision_name);

/// Spokes whose forces do not cancel.
NetworkParts hub_of(uint32_t spokes) {
  reference::SplitMix random(9);
  NetworkParts hub;
  hub.positions = {{0, 0, 0}};
  hub.masses = {1};
  for (uint32_t i = 1; i <= spokes; ++i) {
    const Vec p{0.1 + random.uniform(), random.uniform(), random.uniform()};
    hub.positions.push_back(reference::through_float(p));
    hub.springs.push_back({0, i, 1 + random.uniform(), 0});
  }
  for (weft::Spring& s : hub.springs) s.stiffness = reference::through_float(s.stiffness);
  return hub;
}

Vec hub_force(const NetworkParts& hub, weft::Evaluation evaluation, weft::Precision precision) {
  weft::WorldDesc desc = plain_world(precision);
  desc.evaluation = evaluation;
  TestWorld test(desc);
  return test.accelerations(add_network(test, hub))[0];
}

/// Error of the sum in units of its size.
double hub_error(uint32_t spokes, weft::Evaluation evaluation, weft::Precision precision) {
  const NetworkParts hub = hub_of(spokes);
  Vec expected;
  for (const weft::Spring& s : hub.springs) expected += s.stiffness * hub.positions[s.b];
  return length(hub_force(hub, evaluation, precision) - expected) / length(expected);
}

TEST(HubSum, IsNearlyAsExactAsAPairwiseOne) {
  // Sequential sums are off by 3.9e-6 at 1e5 terms, pairwise ones by 7e-8.
  for (weft::Evaluation e : {weft::Evaluation::gather, weft::Evaluation::scatter}) {
    EXPECT_LE(hub_error(100000, e, weft::Precision::float32), 1e-6);
    EXPECT_LE(hub_error(3000, e, weft::Precision::float32), 1e-6);
    EXPECT_LE(hub_error(129, e, weft::Precision::float32), 1e-6);
  }
}

TEST(HubSum, IsTheSameBothWaysAroundEveryLimit) {
  for (uint32_t spokes :
       {1u, 31u, 32u, 33u, 127u, 128u, 129u, 159u, 160u, 161u, 1023u, 1024u, 1025u, 2048u, 2049u}) {
    for (weft::Precision p : {weft::Precision::float32, weft::Precision::float64}) {
      const NetworkParts hub = hub_of(spokes);
      EXPECT_TRUE(same_bits(hub_force(hub, weft::Evaluation::gather, p),
                            hub_force(hub, weft::Evaluation::scatter, p)))
          << spokes;
      EXPECT_LE(hub_error(spokes, weft::Evaluation::gather, p),
                p == weft::Precision::float32 ? 2e-6 : 1e-14)
          << spokes;
    }
  }
}

/// Two hubs of 200 spokes each; one spoke in two belongs to the other's neighbourhood, so that both
/// hubs are stored among the first vertices.
NetworkParts two_hubs(Vec to_first, Vec to_second) {
  NetworkParts parts;
  parts.positions = {{0, 0, 0}, {0, 0, 0}};
  parts.masses = {1};
  for (uint32_t i = 0; i < 200; ++i) {
    parts.positions.push_back(to_first);
    parts.springs.push_back({0, uint32_t(parts.positions.size() - 1), 1, 0});
    parts.positions.push_back(to_second);
    parts.springs.push_back({1, uint32_t(parts.positions.size() - 1), 1, 0});
  }
  parts.springs.push_back({0, 1, 1, 0});
  return parts;
}

TEST(HubSum, TwoHubsThatAreNeighboursAreBothPulledAndBothDamped) {
  for (weft::Evaluation e : {weft::Evaluation::gather, weft::Evaluation::scatter}) {
    weft::WorldDesc desc = plain_world(weft::Precision::float64);
    desc.evaluation = e;
    TestWorld test(desc);
    const weft::ClothId id = add_network(test, two_hubs({1, 0, 0}, {0, 2, 0}));
    const std::vector<Vec> a = test.accelerations(id);
    expect_near(a[0], {200, 0, 0}, 1e-9);
    expect_near(a[1], {0, 400, 0}, 1e-9);
    // Damping alone, of spokes that fly outwards.
    desc.start = weft::Start::lagged;
    TestWorld damped(desc);
    NetworkParts parts = two_hubs({1, 0, 0}, {0, 2, 0});
    for (weft::Spring& s : parts.springs) s.stiffness = 0;
    parts.velocities.assign(parts.positions.size(), Vec{});
    for (size_t i = 2; i < parts.positions.size(); ++i)
      parts.velocities[i] = 3 * parts.positions[i];
    weft::ClothDesc cloth;
    cloth.spring_damping = 0.5;
    const weft::ClothId wet = add_network(damped, parts, cloth);
    damped.check(damped.world().prepare(1e-6));
    const std::vector<Vec> b = damped.accelerations(wet);
    expect_near(b[0], {200 * 0.5 * 3, 0, 0}, 1e-5);
    expect_near(b[1], {0, 200 * 0.5 * 6, 0}, 1e-5);
  }
}

TEST(HubSum, IsThatOfItsClothWhateverClothsComeBehind) {
  for (weft::Evaluation e : {weft::Evaluation::gather, weft::Evaluation::scatter})
    for (const uint32_t spokes : {129u, 300u, 2100u}) {
      weft::WorldDesc desc = plain_world(weft::Precision::float32);
      desc.evaluation = e;
      desc.unsafe = true;
      TestWorld alone(desc), among(desc);
      const NetworkParts parts = hub_of(spokes);
      weft::ClothDesc cloth;
      cloth.spring_damping = 1e-3;
      const weft::ClothId one = add_network(alone, parts, cloth);
      add_network(among, hub_of(140), cloth);
      const weft::ClothId middle = add_network(among, parts, cloth);
      add_network(among, hub_of(333), cloth);
      for (TestWorld* test : {&alone, &among}) test->step(1e-3, 5);
      const std::vector<Vec> x = alone.positions(one, spokes + 1);
      const std::vector<Vec> y = among.positions(middle, spokes + 1);
      for (size_t i = 0; i < x.size(); ++i)
        ASSERT_TRUE(same_bits(x[i], y[i])) << spokes << ' ' << i;
    }
}

}  // namespace
}  // namespace weft_tests::scatter
