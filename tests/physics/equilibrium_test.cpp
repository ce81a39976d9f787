// Static equilibria that damped motion must come to rest at: hanging chains and pinned sheets.
#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

weft::WorldDesc world_with_gravity(weft::double3 gravity) {
  weft::WorldDesc desc = plain_world(weft::Precision::float64);
  desc.gravity = gravity;
  return desc;
}

TEST(Equilibrium, VerticalChainStretchesUnderTheWeightBelow) {
  const double m = 0.05, k = 200, l0 = 0.1, g = 9.81;
  NetworkParts parts;
  parts.positions = {{0, 0, 0}};
  parts.masses = {m};
  parts.pins = {0};
  double y = 0;
  for (int i = 0; i < 10; ++i) {
    y -= l0 + (10 - i) * m * g / k;
    parts.positions.push_back({0, y, 0});
    parts.springs.push_back({uint32_t(i), uint32_t(i + 1), k, l0});
  }
  EXPECT_NEAR(parts.positions[1].y, -0.124525, 1e-15);
  EXPECT_NEAR(parts.positions[5].y, -0.5981, 1e-14);
  EXPECT_NEAR(parts.positions[10].y, -1.1348875, 1e-14);
  TestWorld test(world_with_gravity({0, -g, 0}));
  const weft::ClothId cloth = add_network(test, parts);
  for (Vec a : test.accelerations(cloth)) EXPECT_LE(length(a), 1e-10);
  test.step(0.01, 10000);
  const std::vector<Vec> x = test.positions(cloth);
  for (size_t i = 0; i < x.size(); ++i) expect_near(x[i], parts.positions[i], 1e-10);
}

TEST(Equilibrium, ChainBetweenTwoPinsIsTheDiscreteCatenary) {
  struct Catenary {
    int n;
    double m, k, l0, span, y_mid, x1, y1, tension;
  };
  for (const Catenary& c : {Catenary{9, 0.05, 200, 0.1, 0.8, -0.334365677956, 0.056812258937,
                                     -0.097420442615, 2.555154980534},
                            Catenary{19, 0.02, 500, 0.05, 0.9, -0.260683527295, 0.035265061930,
                                     -0.042031687655, 2.433042850332},
                            Catenary{19, 0.02, 50, 0.05, 1.2, -0.487958389760, 0.047830205892,
                                     -0.080224374753, 2.170031825415}}) {
    NetworkParts parts;
    parts.masses = {c.m};
    parts.pins = {0, uint32_t(c.n + 1)};
    for (int i = 0; i <= c.n + 1; ++i) {
      const double s = double(i) / (c.n + 1);
      parts.positions.push_back({s * c.span, 4 * c.y_mid * s * (1 - s), 0});
      if (i > 0) parts.springs.push_back({uint32_t(i - 1), uint32_t(i), c.k, c.l0});
    }
    TestWorld test(world_with_gravity({0, -9.81, 0}));
    weft::ClothDesc desc;
    desc.drag = 5 * c.m;
    const weft::ClothId cloth = add_network(test, parts, desc);
    test.step(0.9 * test.world().stability().dt_bound, 20000);
    const std::vector<Vec> x = test.positions(cloth);
    EXPECT_NEAR(x[size_t(c.n + 1) / 2].y, c.y_mid, 1e-10);
    expect_near(x[1], {c.x1, c.y1, 0}, 1e-10);
    EXPECT_NEAR(c.k * (length(x[1] - x[0]) - c.l0), c.tension, 1e-9);
  }
}

struct Rest {
  const char* name;
  uint32_t n;
  enum { corners, corners_out, ring, top_corners } pins;
  double energy;
  Vec c, e, d;
};

void PrintTo(const Rest& rest, std::ostream* out) { *out << rest.name << rest.n; }

class RestingSheet : public testing::TestWithParam<Rest> {};

TEST_P(RestingSheet, ComesToThePublishedRest) {
  const Rest rest = GetParam();
  const uint32_t n = rest.n;
  std::vector<weft::Pin> pins;
  std::vector<weft::double3> x;
  for (Vec p : reference::grid_positions(n, n)) {
    const uint32_t i = uint32_t(x.size()), r = i / n, c = i % n;
    const bool edge_r = r == 0 || r == n - 1, edge_c = c == 0 || c == n - 1;
    const bool pinned = rest.pins == Rest::ring          ? edge_r || edge_c
                        : rest.pins == Rest::top_corners ? r == n - 1 && edge_c
                                                         : edge_r && edge_c;
    // Pulled out as a whole, so that the sheet has no slack from which other minima are near.
    const double s = rest.pins == Rest::corners_out ? 1.1 : rest.pins == Rest::ring ? 1.05 : 1;
    x.push_back({s * (p.x - 0.5), s * (p.y - 0.5), 0});
    if (pinned) pins.push_back({i, weft::Pin::fixed});
  }
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.material.stiffness = 200;
  grid.material.mass.value = 0.25;
  weft::ClothDesc desc;
  desc.positions = weft::View<weft::double3>(x);
  desc.pins = pins;
  desc.drag = 4 * 0.25 / (n * n);
  desc.drag_model = weft::DragModel::lagged;
  const bool planar = rest.pins == Rest::top_corners;
  TestWorld test(
      world_with_gravity(planar ? weft::double3{0, -9.81, 0} : weft::double3{0, 0, -9.81}));
  const weft::ClothId cloth = test.add(grid, desc);
  test.step(0.8 * test.world().stability().dt_bound, planar ? 120000 : 60000);
  const std::vector<Vec> at = test.positions(cloth);
  expect_near(at[n / 2 * n + n / 2], rest.c, 1e-9);
  if (rest.pins != Rest::ring) expect_near(at[n / 2], rest.e, 1e-9);
  expect_near(at[n + 1], rest.d, 1e-9);
  const weft::Mechanics mechanics = test.mechanics();
  // The potential energy of weft leaves out the pins, and a pin does not count its own height.
  double pinned = 0;
  for (const weft::Pin& pin : pins)
    pinned += 0.25 / (n * n) * 9.81 * (planar ? x[pin.vertex].y : x[pin.vertex].z);
  EXPECT_NEAR(mechanics.elastic + mechanics.potential + pinned, rest.energy, 1e-9);
  if (planar) {
    for (Vec p : at) EXPECT_EQ(p.z, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Sheets, RestingSheet,
                         testing::Values(Rest{"corners",
                                              8,
                                              Rest::corners,
                                              -0.107017311552,
                                              {0.0715911694, 0.0715911694, -0.0718457716},
                                              {0.0717792628, -0.4996361983, -0.0782853388},
                                              {-0.3572813421, -0.3572813421, -0.0417963437}},
                                         Rest{"corners_out",
                                              8,
                                              Rest::corners_out,
                                              4.452594839607,
                                              {0.0740475990, 0.0740475990, -0.0059104903},
                                              {0.0724520812, -0.5003217522, -0.0158769092},
                                              {-0.3739079069, -0.3739079069, -0.0034536350}},
                                         Rest{"corners_out",
                                              16,
                                              Rest::corners_out,
                                              3.615465786276,
                                              {0.0345950109, 0.0345950109, -0.0081381235},
                                              {0.0336811671, -0.4986007298, -0.0204561101},
                                              {-0.4575587750, -0.4575587750, -0.0050444281}},
                                         Rest{"drum",
                                              8,
                                              Rest::ring,
                                              4.215985314486,
                                              {0.0743814510, 0.0743814510, -0.0018391866},
                                              {},
                                              {-0.3715184116, -0.3715184116, -0.0008450944}},
                                         Rest{"drum",
                                              16,
                                              Rest::ring,
                                              4.792835954343,
                                              {0.0348537293, 0.0348537293, -0.0017434256},
                                              {},
                                              {-0.4529452223, -0.4529452223, -0.0002742850}},
                                         Rest{"planar",
                                              8,
                                              Rest::top_corners,
                                              -0.005526939337,
                                              {0.0717305453, 0.0672308664, 0},
                                              {0.0712266600, -0.5050394298, 0},
                                              {-0.3564863775, -0.3622492568, 0}}),
                         [](const testing::TestParamInfo<Rest>& info) {
                           return info.param.name + std::to_string(info.param.n);
                         });

}  // namespace
}  // namespace weft_tests
