// Errors of the elastic pendulum and of a small sheet at T = 1 against converged solutions: the
// published error of every step and its order.
#include "reference/networks.h"
#include "reference/sheets.h"

#include <algorithm>

namespace weft_tests {
namespace {

double largest_component(Vec v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

struct Scheme {
  const char* name;
  weft::Start start;
  double drag;
  weft::DragModel model;
  double errors[4];  // N = 100, 400, 1600, 3200
  double order;
};

void PrintTo(const Scheme& scheme, std::ostream* out) { *out << scheme.name; }

class PendulumConvergence : public testing::TestWithParam<Scheme> {};

TEST_P(PendulumConvergence, ErrorsAndOrderAreThePublishedOnes) {
  const Scheme scheme = GetParam();
  const Vec expected = scheme.drag > 0 ? Vec{-0.189462211853, -1.061109937669, -0.013242361234}
                                       : Vec{-0.974534973616, -0.641657549303, -0.209214849969};
  const int counts[4] = {100, 400, 1600, 3200};
  double errors[4];
  for (int i = 0; i < 4; ++i) {
    weft::WorldDesc world = plain_world(weft::Precision::float64, scheme.start);
    world.gravity = {0, -9.81, 0};
    TestWorld test(world);
    AnchoredMass mass;
    mass.start = {1.2, 0, 0.1};
    mass.velocity = {0, 0.5, 0.3};
    mass.drag = scheme.drag;
    mass.drag_model = scheme.model;
    const weft::ClothId cloth = mass.add_to(test);
    test.step(1.0 / counts[i], counts[i]);
    errors[i] = largest_component(test.position(cloth, 1) - expected);
    EXPECT_NEAR(errors[i], scheme.errors[i], 2e-4 * scheme.errors[i]) << counts[i];
  }
  EXPECT_NEAR(std::log2(errors[2] / errors[3]), scheme.order, 0.1);
}

constexpr auto central = weft::DragModel::central, lagged = weft::DragModel::lagged;
INSTANTIATE_TEST_SUITE_P(Schemes, PendulumConvergence,
                         testing::Values(Scheme{"taylor",
                                                weft::Start::taylor,
                                                0,
                                                central,
                                                {7.1844e-4, 4.4889e-5, 2.8055e-6, 7.0138e-7},
                                                2},
                                         Scheme{"lagged_start",
                                                weft::Start::lagged,
                                                0,
                                                central,
                                                {1.6172e-2, 3.9140e-3, 9.7039e-4, 4.8452e-4},
                                                1},
                                         Scheme{"lagged_drag",
                                                weft::Start::taylor,
                                                2,
                                                lagged,
                                                {6.5305e-3, 1.5711e-3, 3.8888e-4, 1.9411e-4},
                                                1},
                                         Scheme{"central_drag",
                                                weft::Start::taylor,
                                                2,
                                                central,
                                                {2.8431e-4, 1.7770e-5, 1.1106e-6, 2.7764e-7},
                                                2}),
                         [](const testing::TestParamInfo<Scheme>& info) {
                           return std::string(info.param.name);
                         });

Sheet small_sheet() {
  Sheet sheet;
  sheet.rows = sheet.columns = 4;
  sheet.stiffness = 100;
  sheet.vertex_mass = 0.05;
  sheet.pins = {12, 15};
  return sheet;
}

/// The sheet at T = 1 from two fine runs of the reference, extrapolated.
std::vector<Vec> converged_sheet() {
  std::vector<Vec> runs[2];
  for (int i = 0; i < 2; ++i) {
    reference::System system = small_sheet().system();
    for (Vec x : system.positions) system.velocities.push_back({0.2 * x.y, 0, 0.3 * x.x});
    system.velocities[12] = system.velocities[15] = {};
    system.gravity = {0, -9.81, -3};
    const int count = 6400 << i;
    reference::Verlet verlet(system, 1.0 / count);
    verlet.steps(count);
    runs[i] = verlet.positions();
  }
  for (size_t i = 0; i < 16; ++i) runs[1][i] = (1 / 3.0) * (4 * runs[1][i] - runs[0][i]);
  return runs[1];
}

TEST(SheetConvergence, ErrorsOfA4x4SheetAreThePublishedOnes) {
  const std::vector<Vec> expected = converged_sheet();
  expect_near(expected[5], {0.340168050234, 0.423139957321, -0.394613377478}, 1e-9);
  const double published[4] = {5.0057e-4, 1.3030e-4, 3.2700e-5, 8.1802e-6};
  double previous = 0;
  for (int i = 0; i < 4; ++i) {
    const int count = 200 << i;
    std::vector<weft::double3> v;
    for (Vec x : small_sheet().start()) v.push_back({0.2 * x.y, 0, 0.3 * x.x});
    weft::WorldDesc world = plain_world(weft::Precision::float64);
    world.gravity = {0, -9.81, -3};
    TestWorld test(world);
    weft::ClothDesc desc;
    desc.velocities = v;
    const weft::ClothId cloth = small_sheet().add_to(test, desc);
    test.step(1.0 / count, count);
    const std::vector<Vec> x = test.positions(cloth);
    double error = 0;
    for (size_t k = 0; k < 16; ++k) error = std::max(error, largest_component(x[k] - expected[k]));
    EXPECT_NEAR(error, published[i], 1e-4 * published[i]) << count;
    if (i == 3) {
      EXPECT_NEAR(std::log2(previous / error), 2, 0.1);
    }
    previous = error;
  }
}

}  // namespace
}  // namespace weft_tests
