// Free flight: the parabola is an exact solution of the discrete equation.
#include "reference/networks.h"

namespace weft_tests {
namespace {

constexpr double g = 9.81;

struct Flight {
  double dt;
  int steps;
};

class FreeFall : public testing::TestWithParam<std::tuple<Flight, weft::Precision>> {
 protected:
  const Flight flight = std::get<0>(GetParam());
  const weft::Precision precision = std::get<1>(GetParam());

  Vec end(weft::Start start, Vec velocity) const {
    weft::WorldDesc desc = plain_world(precision, start);
    desc.gravity = {0, -g, 0};
    TestWorld test(desc);
    const weft::ClothId cloth = add_particles(test, {{0, 0, 0}}, velocity);
    test.step(flight.dt, flight.steps);
    return test.position(cloth, 0);
  }
};

TEST_P(FreeFall, TaylorStartIsTheParabola) {
  const double t = flight.dt * flight.steps;
  const Vec v{1.5, 3, -0.25}, expected{v.x * t, v.y * t - g * t * t / 2, v.z * t};
  expect_near(end(weft::Start::taylor, v), expected,
              tolerance(precision, length(v) * t + g * t * t / 2));
}

TEST_P(FreeFall, LaggedStartIsOneHalfStepAhead) {
  const double t = flight.dt * flight.steps, drop = g * t * (t + flight.dt) / 2;
  expect_near(end(weft::Start::lagged, {}), {0, -drop, 0}, tolerance(precision, drop));
}

std::string flight_name(const testing::TestParamInfo<FreeFall::ParamType>& info) {
  const auto& [flight, precision] = info.param;
  return std::to_string(flight.steps) + "_steps_" + weft::to_string(precision);
}
INSTANTIATE_TEST_SUITE_P(Flights, FreeFall,
                         testing::Combine(testing::Values(Flight{0.1, 8}, Flight{0.01, 70},
                                                          Flight{1.0 / 1024, 777},
                                                          Flight{0.00025, 3000}),
                                          both_precisions()),
                         flight_name);

TEST(FreeFallInPositionForm, IsTheSameScheme) {
  for (const Flight flight : {Flight{0.1, 8}, Flight{0.01, 70}, Flight{0.00025, 3000}}) {
    weft::WorldDesc desc = plain_world(weft::Precision::float64);
    desc.gravity = {0, -g, 0};
    desc.form = weft::Form::position;
    TestWorld test(desc);
    const weft::ClothId cloth = add_particles(test, {{0, 0, 0}}, {0, 1, 0});
    test.step(flight.dt, flight.steps);
    const double t = flight.dt * flight.steps;
    EXPECT_NEAR(test.position(cloth, 0).y, t - g * t * t / 2, 1e-10) << flight.dt;
  }
}

using FreeFlight = BothPrecisions;

TEST_P(FreeFlight, MassDoesNotChangeTheFall) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -g, 0};
  uint64_t hashes[3];
  int i = 0;
  for (double mass : {0.001, 1.0, 1e6}) {
    TestWorld test(desc);
    add_particles(test, {{0, 0, 0}}, {0, 1, 0}, mass);
    test.step(0.01, 100);
    hashes[i++] = test.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[1], hashes[2]);
}

TEST_P(FreeFlight, SheetAtRestFallsAsAWhole) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, 0, -g};
  TestWorld test(desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = 17;  // spacing 1/16: the rest shape is exact
  const weft::ClothId cloth = test.add(grid, weft::ClothDesc{});
  const double dt = 0.001;
  test.step(dt, 500);
  const std::vector<Vec> x = test.positions(cloth);
  const double drop = g * 0.125;
  for (size_t i = 0; i < x.size(); ++i) {
    EXPECT_TRUE(same_bits(x[i].z, x[0].z)) << i;
    EXPECT_EQ(x[i].x, double(i % 17) / 16) << i;
    EXPECT_EQ(x[i].y, double(i / 17) / 16) << i;
  }
  EXPECT_NEAR(x[0].z, -drop, tolerance(GetParam(), drop));
}

TEST_P(FreeFlight, ConstantForceAcceleratesByItsMass) {
  TestWorld test(plain_world(GetParam()));
  const std::vector<weft::double3> at{{0, 0, 0}, {5, 0, 0}};
  const std::vector<double> masses{0.5, 0.5};
  // Several forces on one vertex add up.
  const std::vector<weft::VertexForce> forces{{0, {1, 0, 0}}, {0, {0, 2, -1}}};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(at);
  network.material.mass.kind = weft::Mass::Kind::per_vertex;
  network.material.mass.values = masses;
  weft::ClothDesc desc;
  desc.forces = forces;
  const weft::ClothId cloth = test.add(network, desc);
  expect_near(test.accelerations(cloth)[0], {2, 4, -2}, tolerance(GetParam(), 4));
  test.step(0.01, 100);
  const std::vector<Vec> x = test.positions(cloth);
  expect_near(x[0], {1, 2, -1}, tolerance(GetParam(), 2));
  EXPECT_TRUE(same_bits(x[1], Vec{5, 0, 0}));
}

INSTANTIATE_TEST_SUITE_P(Precision, FreeFlight, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
