// Drag -c v in both models: damped oscillator, damped flight, terminal velocity.
#include "reference/closed_forms.h"
#include "reference/networks.h"

namespace weft_tests {
namespace {

constexpr double c = 2;

struct Damped {
  double dt;
  int steps;
  double lagged;  // published x_n of setup A with c = 2
};

class DampedSetupA : public testing::TestWithParam<std::tuple<Damped, weft::Precision>> {
 protected:
  const Damped row = std::get<0>(GetParam());
  const weft::Precision precision = std::get<1>(GetParam());

  double end(weft::DragModel model, weft::Form form) const {
    weft::WorldDesc desc = plain_world(precision);
    desc.form = form;
    TestWorld test(desc);
    AnchoredMass mass;
    mass.drag = c;
    mass.drag_model = model;
    const weft::ClothId cloth = mass.add_to(test);
    test.step(row.dt, row.steps);
    return test.position(cloth, 1).x;
  }
};

TEST_P(DampedSetupA, LaggedModelFollowsItsRecurrence) {
  EXPECT_NEAR(end(weft::DragModel::lagged, weft::Form::summed), row.lagged,
              tolerance(precision, row.lagged));
}

TEST_P(DampedSetupA, CentralModelFollowsItsRecurrence) {
  const double expected =
      1 + reference::central_drag_oscillator(0.25, 10, c * row.dt, row.dt, row.steps);
  EXPECT_GT(std::abs(expected - row.lagged), 4e-8);  // the two models can be told apart
  EXPECT_NEAR(end(weft::DragModel::central, weft::Form::summed), expected,
              tolerance(precision, expected));
}

class DampedPositionForm : public DampedSetupA {};  // float32 has no useful tolerance in this form

TEST_P(DampedPositionForm, IsTheSameScheme) {
  const double expected =
      1 + reference::central_drag_oscillator(0.25, 10, c * row.dt, row.dt, row.steps);
  EXPECT_NEAR(end(weft::DragModel::lagged, weft::Form::position), row.lagged, 1e-10);
  EXPECT_NEAR(end(weft::DragModel::central, weft::Form::position), expected, 1e-10);
}

std::string row_name(const testing::TestParamInfo<DampedSetupA::ParamType>& info) {
  const auto& [row, precision] = info.param;
  return "dt" + std::to_string(int(std::lround(1000 * row.dt))) + "ms_" +
         std::to_string(row.steps) + "_" + weft::to_string(precision);
}
const auto damped_rows =
    testing::Values(Damped{0.001, 100, 1.142148515298710}, Damped{0.001, 1000, 0.916059721894669},
                    Damped{0.01, 100, 0.918813982507019}, Damped{0.01, 1000, 1.000008555448582},
                    Damped{0.05, 100, 1.000358500626847});
INSTANTIATE_TEST_SUITE_P(Steps, DampedSetupA, testing::Combine(damped_rows, both_precisions()),
                         row_name);
INSTANTIATE_TEST_SUITE_P(Steps, DampedPositionForm,
                         testing::Combine(damped_rows, testing::Values(weft::Precision::float64)),
                         row_name);

using Drag = BothPrecisions;

TEST_P(Drag, LaggedFreeFlightFollowsItsRecurrence) {
  const double dt = 0.01, mass = 0.5, g = -9.81, big_g = c * dt / mass;
  weft::WorldDesc desc = plain_world(GetParam(), weft::Start::lagged);
  desc.gravity = {0, g, 0};
  TestWorld test(desc);
  const weft::ClothId cloth =
      add_particles(test, {{0, 0, 0}}, {3, 1, 0}, mass, c, weft::DragModel::lagged);
  double vx = 3, vy = 1, x = 0, y = 0;
  for (int n = 1; n <= 200; ++n) {
    test.step(dt);
    vx = (1 - big_g) * vx;
    vy = (1 - big_g) * vy + g * dt;
    x += vx * dt;
    y += vy * dt;
    const Vec p = test.position(cloth, 0);
    const double within = tolerance(GetParam(), std::hypot(x, y));
    ASSERT_NEAR(p.x, x, within) << n;
    ASSERT_NEAR(p.y, y, within) << n;
  }
}

TEST_P(Drag, TerminalVelocityIsWeightByDrag) {
  const double mass = 0.25, expected = -9.81 * mass / c;
  for (weft::DragModel model : {weft::DragModel::lagged, weft::DragModel::central}) {
    weft::WorldDesc desc = plain_world(GetParam());
    desc.gravity = {0, -9.81, 0};
    TestWorld test(desc);
    const weft::ClothId cloth = add_particles(test, {{0, 0, 0}}, {}, mass, c, model);
    test.step(0.01, 600);
    const double at_600 = test.position(cloth, 0).y;
    EXPECT_NEAR(test.velocities(cloth)[0].y, expected, tolerance(GetParam(), expected));
    test.step(0.01, 100);
    EXPECT_NEAR(test.position(cloth, 0).y - at_600, expected, tolerance(GetParam(), 8.6));
  }
}

TEST_P(Drag, GOfOneStopsInOneStep) {
  TestWorld test(plain_world(GetParam(), weft::Start::lagged));
  // c dt/m = 2 * 0.5/1
  const weft::ClothId cloth =
      add_particles(test, {{0, 0, 0}}, {3, 0, 0}, 1, c, weft::DragModel::lagged);
  test.step(0.5);
  EXPECT_EQ(test.position(cloth, 0).x, 0);
  test.step(0.5);
  EXPECT_EQ(test.position(cloth, 0).x, 0);
}

TEST_P(Drag, CentralModelIsStableForEveryDrag) {
  AnchoredMass mass;
  mass.drag = 1e6;
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  test.step(0.19, 1000);
  const double x = test.position(cloth, 1).x;
  EXPECT_GE(x, 0.75);
  EXPECT_LE(x, 1.2500001);
}

TEST_P(Drag, ZeroDragChangesNoBit) {
  TestWorld without(plain_world(GetParam())), central(plain_world(GetParam())),
      lagged(plain_world(GetParam()));
  AnchoredMass mass;
  mass.add_to(without);
  mass.drag_model = weft::DragModel::lagged;
  mass.add_to(lagged);
  mass.drag_model = weft::DragModel::central;
  mass.spring_damping = 0;
  mass.add_to(central);
  for (TestWorld* test : {&without, &central, &lagged}) test->step(0.01, 100);
  EXPECT_EQ(without.hash(), central.hash());
  EXPECT_EQ(without.hash(), lagged.hash());
}

INSTANTIATE_TEST_SUITE_P(Precision, Drag, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
