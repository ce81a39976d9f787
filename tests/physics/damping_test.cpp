// Damping along the springs, -b (relative velocity d/dt along the spring), against the reference
// and its closed form on a line.
#include "reference/closed_forms.h"
#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

using SpringDamping = BothPrecisions;

TEST_P(SpringDamping, OnALineItIsLaggedDragTowardsTheAnchor) {
  for (double dt : {0.001, 0.01, 0.05}) {
    AnchoredMass mass;
    mass.spring_damping = 2;
    TestWorld test(plain_world(GetParam()));
    const weft::ClothId cloth = mass.add_to(test);
    test.step(dt, 100);
    const double expected = 1 + reference::lagged_drag_oscillator(0.25, 10, 2 * dt, dt, 100);
    EXPECT_NEAR(test.position(cloth, 1).x, expected, tolerance(GetParam(), expected)) << dt;
  }
}

TEST_P(SpringDamping, LeavesRigidMotionAlone) {
  TestWorld damped(plain_world(GetParam())), free(plain_world(GetParam()));
  for (TestWorld* test : {&damped, &free}) {
    Sheet sheet;
    sheet.rows = sheet.columns = 17;
    weft::ClothDesc desc;
    desc.velocity = {0.5, -1, 2};
    desc.spring_damping = test == &damped ? 0.5 : 0;
    const weft::ClothId cloth = sheet.add_to(*test, desc);
    test->step(1.0 / 4096, 256);
    const std::vector<Vec> x = test->positions(cloth);
    expect_near(x[0], {0.03125, -0.0625, 0.125}, tolerance(GetParam(), 0.125));
  }
}

TEST_P(SpringDamping, SheetFollowsTheReference) {
  const double dt = 5e-4, b = 0.2;
  for (bool network : {false, true})
    for (weft::Form form : {weft::Form::summed, weft::Form::position}) {
      if (form == weft::Form::position && GetParam() == weft::Precision::float32) continue;
      Sheet sheet;
      sheet.noise = 0.01;
      sheet.pins = {0, 7};
      reference::System system = sheet.system();
      system.gravity = {0, -9.81, 0};
      system.spring_damping = b;
      reference::Verlet verlet(system, dt);
      verlet.steps(100);
      weft::WorldDesc desc = plain_world(GetParam());
      desc.gravity = {0, -9.81, 0};
      desc.form = form;
      TestWorld test(desc);
      weft::ClothDesc cloth_desc;
      cloth_desc.spring_damping = b;
      const weft::ClothId cloth =
          network ? sheet.add_network_to(test, cloth_desc) : sheet.add_to(test, cloth_desc);
      test.step(dt, 100);
      const std::vector<Vec> x = test.positions(cloth);
      for (size_t i = 0; i < x.size(); ++i)
        expect_near(x[i], verlet.positions()[i], tolerance(GetParam(), 1));
    }
}

TEST_P(SpringDamping, DraggedSheetFollowsTheReference) {
  const double dt = 5e-4, c = 0.4;
  for (weft::DragModel model : {weft::DragModel::central, weft::DragModel::lagged}) {
    Sheet sheet;
    sheet.noise = 0.01;
    sheet.pins = {56, 63};
    reference::System system = sheet.system();
    system.gravity = {0, 0, -9.81};
    system.drag = c;
    system.central_drag = model == weft::DragModel::central;
    system.velocities.assign(64, {0.5, 1, -0.25});
    system.velocities[56] = system.velocities[63] = {};
    reference::Verlet verlet(system, dt);
    verlet.steps(100);
    weft::WorldDesc desc = plain_world(GetParam());
    desc.gravity = {0, 0, -9.81};
    TestWorld test(desc);
    weft::ClothDesc cloth_desc;
    cloth_desc.drag = c;
    cloth_desc.drag_model = model;
    cloth_desc.velocity = {0.5, 1, -0.25};
    const weft::ClothId cloth = sheet.add_to(test, cloth_desc);
    test.step(dt, 100);
    const std::vector<Vec> x = test.positions(cloth), v = test.velocities(cloth);
    for (size_t i = 0; i < x.size(); ++i) {
      expect_near(x[i], verlet.positions()[i], tolerance(GetParam(), 1));
      if (GetParam() == weft::Precision::float64 && i != 56 && i != 63)
        expect_near(v[i], verlet.velocity(i), 1e-8);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, SpringDamping, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
