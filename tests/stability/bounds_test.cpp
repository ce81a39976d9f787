// The stable step that weft reports: never larger than the exact limit, equal to it where the limit
// is known in closed form.
#include "reference/closed_forms.h"
#include "reference/eigenvalue.h"
#include "reference/networks.h"
#include "reference/sheets.h"

#include <limits>
#include <numbers>

namespace weft_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double bound_of(const AnchoredMass& mass, weft::Precision precision = weft::Precision::float64) {
  TestWorld test(plain_world(precision));
  mass.add_to(test);
  return test.world().stability().dt_bound;
}

void expect_bound(double actual, double expected) {
  EXPECT_NEAR(actual, expected, 1e-9 * expected);
}

/// Two unit masses, the first pinned, one spring.
weft::Stability bound_of_pair(double stiffness, double spring_damping, double lagged_drag = 0) {
  TestWorld test;
  const std::vector<weft::double3> x{{0, 0, 0}, {1, 0, 0}};
  const weft::Spring spring{0, 1};
  const weft::Pin pin{0};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.springs = weft::View<weft::Spring>(&spring, 1);
  network.material.stiffness = stiffness;
  network.material.mass.value = 2;
  weft::ClothDesc cloth;
  cloth.fabric = test.take(test.context().cook(network));
  cloth.pins = weft::View<weft::Pin>(&pin, 1);
  cloth.spring_damping = spring_damping;
  cloth.drag = lagged_drag;
  cloth.drag_model = weft::DragModel::lagged;
  test.take(test.world().create_cloth(cloth));
  return test.world().stability();
}

TEST(Bound, DampingFarAboveStiffnessKeepsItsDigits) {
  for (const double b : {1e4, 1e6, 1e7, 1e12, 1e18}) {
    EXPECT_NEAR(bound_of_pair(1e-3, b).dt_bound * b / 2, 1, 1e-9) << b;
  }
}

TEST(Bound, NamesWhatSetsIt) {
  const weft::Stability drag = bound_of_pair(1, 0, 1e3);
  EXPECT_EQ(drag.a, 1u);
  EXPECT_EQ(drag.b, 1u);
  const weft::Stability damping = bound_of_pair(0, 1e3, 1);
  EXPECT_EQ(damping.a, 0u);
  EXPECT_EQ(damping.b, 1u);
}

TEST(Bound, SingleSpringIsExact) {
  for (weft::Precision precision : {weft::Precision::float32, weft::Precision::float64})
    expect_bound(bound_of(AnchoredMass{}, precision), 0.2);
}

TEST(Bound, NothingBoundsFreeParticlesPinsAndEmptyWorlds) {
  TestWorld test(plain_world(weft::Precision::float64));
  EXPECT_EQ(test.world().stability().dt_bound, infinity);
  add_particles(test, {{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(test.world().stability().dt_bound, infinity);
  NetworkParts pinned;
  pinned.positions = {{0, 0, 0}, {1, 0, 0}};
  pinned.springs = {{0, 1, 1e6, 1}};
  pinned.masses = {1e-6};
  pinned.pins = {0, 1};
  add_network(test, pinned);
  EXPECT_EQ(test.world().stability().dt_bound, infinity);
}

TEST(Bound, TwoMassesAreExact) {
  for (double ratio : {1.0, 10.0, 1e3, 1e6}) {
    NetworkParts pair;
    pair.positions = {{0, 0, 0}, {1, 0, 0}};
    pair.springs = {{0, 1, 100, 1}};
    pair.masses = {ratio, 1};
    TestWorld test(plain_world(weft::Precision::float64));
    const weft::ClothId cloth = add_network(test, pair);
    expect_bound(test.world().stability().dt_bound, 2 / std::sqrt(100 * (1 + 1 / ratio)));
    const weft::Stability bound = test.take(test.world().stability(cloth));
    EXPECT_EQ(std::min(bound.a, bound.b), 0u);
    EXPECT_EQ(std::max(bound.a, bound.b), 1u);
    EXPECT_EQ(bound.cloth, cloth);
  }
}

TEST(Bound, LargeSeedGridIsGershgorin) {
  for (uint32_t n : {8u, 12u, 16u, 24u, 32u, 48u, 64u}) {
    Sheet sheet;
    sheet.rows = sheet.columns = n;
    TestWorld test(plain_world(weft::Precision::float32));
    test.add(sheet.grid(), weft::ClothDesc{});
    const double unit = std::sqrt(sheet.vertex_mass / sheet.stiffness);
    expect_bound(test.world().stability().dt_bound, unit * 2 / std::sqrt(24.0));
    EXPECT_NEAR(test.world().stability().dt_bound / unit, 0.408248290, 1e-9);
  }
}

TEST(Bound, SeedGridNeverExceedsTheExactLimit) {
  struct Limit {
    uint32_t n;
    double at_rest, without_rest_length;
  };
  for (const Limit limit :
       {Limit{8, 0.6594067479, 0.5036740350}, Limit{12, 0.6413381718, 0.4848252955},
        Limit{16, 0.6343561645, 0.4782510007}, Limit{24, 0.6290481938, 0.4735939604},
        Limit{32, 0.6271570934, 0.4719117686}, Limit{48, 0.6258000691, 0.4707219611},
        Limit{64, 0.6253223971, 0.4703051774}}) {
    weft::GridDesc grid;
    grid.rows = grid.columns = limit.n;
    grid.material.stiffness = 1;
    grid.material.mass.value = limit.n * limit.n;
    TestWorld test(plain_world(weft::Precision::float64));
    test.add(grid, weft::ClothDesc{});
    const double bound = test.world().stability().dt_bound;
    EXPECT_LT(bound, limit.without_rest_length);
    EXPECT_LT(bound, limit.at_rest);
    EXPECT_GT(bound, 0.8 * limit.without_rest_length);  // nor is it needlessly small
  }
}

TEST(Bound, EveryStencilAndSizeIsTheEdgeBoundAndBelowTheExactLimit) {
  for (weft::Stencil stencil :
       {weft::Stencil::seed12, weft::Stencil::classic12, weft::Stencil::quad4, weft::Stencil::tri6})
    for (uint32_t rows : {1u, 2u, 3u, 4u, 5u, 9u})
      for (uint32_t columns : {2u, 3u, 5u, 8u}) {
        Sheet sheet;
        sheet.rows = rows;
        sheet.columns = columns;
        sheet.stencil = stencil;
        const auto springs = sheet.system().springs;
        const std::vector<double> inverse(sheet.count(), 1 / sheet.vertex_mass);
        TestWorld test(plain_world(weft::Precision::float64));
        test.add(sheet.grid(), weft::ClothDesc{});
        const double bound = test.world().stability().dt_bound;
        expect_bound(bound, reference::edge_bound(springs, inverse));
        const double exact = reference::largest_laplacian_eigenvalue(springs, inverse, 400);
        EXPECT_LE(bound, 2 / std::sqrt(exact) * (1 + 1e-9)) << rows << " x " << columns;
      }
}

TEST(Bound, PinsCountAsInfiniteMasses) {
  Sheet sheet;
  sheet.rows = sheet.columns = 5;
  sheet.pins = {6, 12, 17};
  std::vector<double> inverse(25, 1 / sheet.vertex_mass);
  for (uint32_t p : sheet.pins) inverse[p] = 0;
  TestWorld grid(plain_world(weft::Precision::float64));
  TestWorld network(plain_world(weft::Precision::float64));
  sheet.add_to(grid);
  sheet.add_network_to(network);
  const double expected = reference::edge_bound(sheet.system().springs, inverse);
  expect_bound(grid.world().stability().dt_bound, expected);
  expect_bound(network.world().stability().dt_bound, expected);
}

TEST(Bound, PinningAndReleasingChangesTheBound) {
  TestWorld test(plain_world(weft::Precision::float64));
  AnchoredMass mass;
  const weft::ClothId cloth = mass.add_to(test);
  const std::vector<uint32_t> anchor{0}, other{1};
  test.check(test.world().release_pins(cloth, anchor));
  expect_bound(test.world().stability().dt_bound, 2 / std::sqrt(200.0));
  const std::vector<weft::double3> target{{1.25, 0, 0}};
  test.check(test.world().move_pins(cloth, other, weft::View<weft::double3>(target)));
  expect_bound(test.world().stability().dt_bound, 0.2);
}

TEST(Bound, HubIsExactForCollinearSpokesAndSafeForOthers) {
  for (uint32_t spokes : {10u, 1000u, 100000u}) {
    NetworkParts hub;
    hub.positions = {{0, 0, 0}};
    hub.masses = {1};
    for (uint32_t i = 1; i <= spokes; ++i) {
      const double angle = 2 * std::numbers::pi * i / spokes;
      hub.positions.push_back({std::cos(angle), std::sin(angle), 0});
      hub.springs.push_back({0, i, 1, 1});
    }
    TestWorld test(plain_world(weft::Precision::float64));
    add_network(test, hub);
    const double bound = test.world().stability().dt_bound;
    expect_bound(bound, 2 / std::sqrt(1.0 + spokes));
    if (spokes == 100000) {
      EXPECT_NEAR(bound, 0.006324523698, 1e-11);
      EXPECT_LE(bound, 0.008944182469);
      EXPECT_GE(bound, 0.4 * 0.008944182469);
    }
  }
}

TEST(Bound, LaggedDampingLowersItAsTheTableSays) {
  struct Limit {
    double zeta, w_dt;
  };
  for (const Limit limit : {Limit{0, 2}, Limit{0.01, 1.980099997500}, Limit{0.1, 1.809975124224},
                            Limit{0.5, 1.236067977500}, Limit{1, 0.828427124746},
                            Limit{2, 0.472135955000}, Limit{5, 0.198039027186}}) {
    ASSERT_NEAR(reference::lagged_damping_limit(limit.zeta), limit.w_dt, 1e-11);
    AnchoredMass mass;  // w = 10, zeta = c/2mw
    mass.drag_model = weft::DragModel::lagged;
    mass.drag = 20 * limit.zeta;
    EXPECT_NEAR(10 * bound_of(mass), limit.w_dt, 1e-9);
    mass.drag = 0;
    mass.spring_damping = 20 * limit.zeta;
    EXPECT_NEAR(10 * bound_of(mass), limit.w_dt, 1e-9);
    mass.drag = 20 * limit.zeta;
    mass.spring_damping = 0;
    mass.drag_model = weft::DragModel::central;
    EXPECT_NEAR(10 * bound_of(mass), 2, 1e-9);
  }
}

TEST(Bound, LaggedDragAloneBoundsAFreeParticle) {
  TestWorld lagged(plain_world(weft::Precision::float64));
  add_particles(lagged, {{0, 0, 0}}, {1, 0, 0}, 0.5, 2, weft::DragModel::lagged);
  const weft::Stability bound = lagged.world().stability();
  expect_bound(bound.dt_bound, 0.5);  // G = c dt/m < 2
  EXPECT_EQ(bound.a, bound.b);
  TestWorld central(plain_world(weft::Precision::float64));
  add_particles(central, {{0, 0, 0}}, {1, 0, 0}, 0.5, 2, weft::DragModel::central);
  EXPECT_EQ(central.world().stability().dt_bound, infinity);
}

TEST(Bound, SpringDampingOfASheetFollowsItsFormula) {
  Sheet sheet;
  sheet.rows = sheet.columns = 12;
  TestWorld test(plain_world(weft::Precision::float64));
  weft::ClothDesc desc;
  desc.spring_damping = 0.2;
  sheet.add_to(test, desc);
  const double k = 24 * 1000 / 0.01, c = 24 * 0.2 / 0.01;
  expect_bound(test.world().stability().dt_bound, (std::sqrt(c * c + 4 * k) - c) / k);
}

TEST(Bound, SoftAndStiffInSeriesIsTheStiffOne) {
  NetworkParts chain;
  chain.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  chain.springs = {{0, 1, 1e8, 1}, {1, 2, 1, 1}};
  chain.masses = {1};
  TestWorld test(plain_world(weft::Precision::float64));
  add_network(test, chain);
  const double bound = test.world().stability().dt_bound;
  expect_bound(bound, 2 / std::sqrt(2e8 + 1));
  EXPECT_LE(bound, 2 / std::sqrt(2e8));
}

TEST(Bound, WorldReportsItsStrictestCloth) {
  TestWorld test(plain_world(weft::Precision::float64));
  AnchoredMass soft, stiff;
  stiff.stiffness = 1e4;
  soft.add_to(test);
  const weft::ClothId worst = stiff.add_to(test);
  soft.add_to(test);
  EXPECT_EQ(test.world().stability().cloth, worst);
  expect_bound(test.world().stability().dt_bound, 0.02);
  test.check(test.world().destroy_cloth(worst));
  expect_bound(test.world().stability().dt_bound, 0.2);
}

TEST(Bound, DampingAndLaggedDragAddUp) {
  // dt^2 K + 2 dt C = 4 with K = 100, C = damping + drag of a unit mass at an anchor.
  for (const double damping : {3.0, 40.0})
    for (const double drag : {2.0, 50.0}) {
      AnchoredMass mass;
      mass.spring_damping = damping;
      mass.drag = drag;
      mass.drag_model = weft::DragModel::lagged;
      const double c = damping + drag;
      expect_bound(bound_of(mass), (std::sqrt(c * c + 400) - c) / 100);
    }
}

TEST(Bound, OfDampingAndLaggedDragTogetherIsTheEdgeOfGrowth) {
  AnchoredMass mass;
  mass.rest_length = 0;
  mass.start = {1, 0, 0};
  mass.spring_damping = 15;
  mass.drag = 20;
  mass.drag_model = weft::DragModel::lagged;
  const double bound = bound_of(mass);
  for (const double ratio : {0.99, 1.01}) {
    weft::WorldDesc desc = plain_world(weft::Precision::float64);
    desc.unsafe = true;
    TestWorld test(desc);
    const weft::ClothId cloth = mass.add_to(test);
    test.step(ratio * bound, 2000);
    const double x = std::abs(test.position(cloth, 1).x);
    if (ratio < 1) {
      EXPECT_LE(x, 1e-3);
    } else {
      EXPECT_GE(x, 1e3);
    }
  }
}

TEST(Bound, CountsTheDampingAtBothEndsOfASpring) {
  // A star of 5 springs of a middle of 0.02 kg with leaves of 0.05 kg.
  for (const bool middle_first : {true, false}) {
    NetworkParts star;
    const uint32_t middle = middle_first ? 0 : 5;
    for (uint32_t v = 0; v < 6; ++v) {
      star.positions.push_back({double(v), double(v * v), 0});
      star.masses.push_back(v == middle ? 0.02 : 0.05);
      if (v != middle) star.springs.push_back({std::min(v, middle), std::max(v, middle), 30, 1});
    }
    weft::ClothDesc cloth;
    cloth.spring_damping = 0.4;
    TestWorld test(plain_world(weft::Precision::float64));
    add_network(test, star, cloth);
    const double k = 30 * (5 / 0.02 + 1 / 0.05), c = 0.4 * (5 / 0.02 + 1 / 0.05);
    expect_bound(test.world().stability().dt_bound, (std::sqrt(c * c + 4 * k) - c) / k);
  }
}

TEST(Bound, WindLowersItAsADragThatCannotOvershoot) {
  // dt^2 K + 2 dt C + 2 G/(1 + G) = 4, G = dt w, w = (rho/12) speed coefficient sum(2 A)/m. In a
  // grid of equal densities, m = density sum(A)/3.
  weft::GridDesc grid;
  grid.rows = grid.columns = 12;
  grid.material.stiffness = 80;
  grid.material.mass.kind = weft::Mass::Kind::density;
  grid.material.mass.value = 0.05;
  TestWorld undamped(plain_world(weft::Precision::float64));
  undamped.add(grid, weft::ClothDesc{});
  const double k = 4 / std::pow(undamped.world().stability().dt_bound, 2);
  for (const double damping : {0.0, 0.03}) {
    const double c = k * damping / 80;
    TestWorld still(plain_world(weft::Precision::float64)),
        windy(plain_world(weft::Precision::float64));
    weft::ClothDesc cloth;
    cloth.spring_damping = damping;
    cloth.velocity = {0, 3, 4};
    still.add(grid, cloth);
    windy.add(grid, cloth);
    const double without = still.world().stability().dt_bound;
    double previous = without;
    for (const double speed : {0.0, 12.0, 500.0, 1e6}) {
      windy.check(windy.world().set_wind({{speed, 0, 0}, 1.2, 0.3, 0.8}));
      const double with = windy.world().stability().dt_bound;
      const double w = 1.2 / 12 * (speed + 5) * 0.8 * 6 / 0.05;
      const double g = with * w;
      EXPECT_NEAR(with * with * k + 2 * with * c + 2 * g / (1 + g), 4, 1e-6) << speed;
      EXPECT_LT(with, previous);
      EXPECT_GE(with, without / (damping > 0 ? 2 : std::sqrt(2)) * 0.9999);
      previous = with;
    }
    windy.check(windy.world().clear_wind());
    EXPECT_EQ(windy.world().stability().dt_bound, without);
  }
}

/// Whichever corner of a triangle is pinned: the wind on it acts on all of its corners.
TEST(Bound, WindLowersItAtEveryCornerOfATriangle) {
  const weft::double3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}};
  for (uint32_t first = 0; first < 3; ++first) {
    for (uint32_t pinned = 0; pinned < 3; ++pinned) {
      const uint32_t indices[] = {first, (first + 1) % 3, (first + 2) % 3};
      weft::MeshDesc mesh;
      mesh.positions = weft::View<weft::double3>(corners, 3);
      mesh.indices = {indices, 3};
      mesh.material.stiffness = 50;
      mesh.material.mass.kind = weft::Mass::Kind::per_vertex;
      const double masses[] = {0.1, 0.1, 0.1};
      mesh.material.mass.values = {masses, 3};
      const weft::Pin pin{pinned};
      weft::ClothDesc cloth;
      cloth.pins = {&pin, 1};
      TestWorld test(plain_world(weft::Precision::float64));
      test.add(mesh, cloth);
      const double k = 4 / std::pow(test.world().stability().dt_bound, 2);
      test.check(test.world().set_wind({{0, 30, 0}, 1.2, 0.9, 0.4}));
      const double with = test.world().stability().dt_bound;
      const double g = with * (1.2 / 12 * 30 * 0.9 * std::sqrt(0.75) / 0.1);  // 2 A = sqrt(3/4)
      EXPECT_NEAR(with * with * k + 2 * g / (1 + g), 4, 1e-6) << first << " " << pinned;
    }
  }
}

}  // namespace
}  // namespace weft_tests
