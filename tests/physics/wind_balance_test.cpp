// Wind against other forces: balances that no step shifts, speeds that no step reverses, and the
// order at which a sheet follows the differential equation.
#include "reference/effects.h"
#include "reference/grid.h"
#include "reference/wind.h"

#include <algorithm>
#include <optional>

namespace weft_tests {
namespace {

double furthest(const std::vector<Vec>& a, const std::vector<Vec>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
  return most;
}

/// A sail of 7 x 6 vertices whose border is pinned, with gravity along it.
struct Sail {
  uint32_t rows = 7, columns = 6;
  double density = 0.1, stiffness = 60;
  reference::Air air{turned({1, 2, 9}, {1, 1, 2}, 25), 1.2, 1.1, 0.3};
  Vec gravity = turned({3, -9, 0}, {1, 1, 2}, 25);

  weft::GridDesc grid() const {
    weft::GridDesc desc;
    desc.rows = rows;
    desc.columns = columns;
    desc.stencil = weft::Stencil::tri6;
    desc.material.stiffness = stiffness;
    desc.material.mass.kind = weft::Mass::Kind::density;
    desc.material.mass.value = density;
    return desc;
  }
  std::vector<Vec> at() const {
    std::vector<Vec> x = reference::grid_positions(rows, columns);
    for (Vec& p : x) p = turned(p, {1, 1, 2}, 25);
    return x;
  }
  std::vector<uint32_t> border() const {
    std::vector<uint32_t> pins;
    for (uint32_t r = 0; r < rows; ++r)
      for (uint32_t c = 0; c < columns; ++c)
        if (r == 0 || r + 1 == rows || c == 0 || c + 1 == columns) pins.push_back(r * columns + c);
    return pins;
  }
  reference::WindySheet sheet(const weft::Fabric& fabric) const {
    reference::WindySheet sheet;
    sheet.mesh = triangles_of(fabric, at());
    sheet.springs = reference::grid_springs_at_rest(rows, columns, reference::tri6(), stiffness,
                                                    sheet.mesh.vertices);
    sheet.masses.assign(sheet.mesh.vertices.size(), 0);
    for (const auto& [i, j, k] : sheet.mesh.faces) {
      const Vec a = sheet.mesh.vertices[i];
      const double area = length(cross(sheet.mesh.vertices[j] - a, sheet.mesh.vertices[k] - a)) / 2;
      for (const uint32_t v : {i, j, k}) sheet.masses[v] += density * area / 3;
    }
    sheet.pinned.assign(sheet.masses.size(), false);
    for (const uint32_t pin : border()) sheet.pinned[pin] = true;
    sheet.air = air;
    sheet.gravity = gravity;
    return sheet;
  }
};

enum class Kind { grid, mesh, scattered };

weft::ClothId add(TestWorld& test, const Sail& sail, Kind kind, weft::ClothDesc cloth) {
  std::vector<weft::Pin> pins;
  for (const uint32_t pin : sail.border()) pins.push_back({pin, weft::Pin::fixed});
  cloth.pins = pins;
  const std::vector<weft::double3> at = to_weft(sail.at());
  cloth.positions = weft::View<weft::double3>(at);
  if (kind != Kind::mesh) return test.add(sail.grid(), cloth);
  const Triangles mesh = triangles_of(test.cook(sail.grid()), sail.at());
  return add_mesh_cloth(test, mesh, sail.grid().material, cloth);
}

struct Balance {
  const char* name;
  weft::Precision precision;
  weft::Form form;
  Kind kind;
  weft::DragModel drag;
};
void PrintTo(const Balance& balance, std::ostream* out) { *out << balance.name; }

class SailBalance : public testing::TestWithParam<Balance> {};

/// Where the sail comes to rest, by Newton's laws with a drag that is not weft's.
std::vector<Vec> statics(const reference::WindySheet& sheet) {
  std::vector<Vec> x = sheet.mesh.vertices, v(x.size());
  const double dt = 5e-4;
  for (int n = 0; n < 40000; ++n) {
    const std::vector<Vec> a = sheet.accelerations(x, std::vector<Vec>(x.size()));
    double most = 0;
    for (size_t i = 0; i < x.size(); ++i) {
      most = std::max(most, length(a[i]));
      v[i] = 0.98 * (v[i] + dt * a[i]);
      x[i] += dt * v[i];
    }
    if (n > 100 && most < 1e-10) break;
  }
  return x;
}

TEST_P(SailBalance, DoesNotDependOnTheStep) {
  const Sail sail;
  const Balance& how = GetParam();
  std::optional<std::vector<Vec>> expected;
  for (const uint32_t substeps : {0u, 24u, 96u}) {
    weft::WorldDesc world = plain_world(how.precision);
    world.form = how.form;
    world.substeps = substeps;
    world.gravity = to_weft(sail.gravity);
    if (how.kind == Kind::scattered) world.evaluation = weft::Evaluation::scatter;
    TestWorld test(world);
    weft::ClothDesc cloth;
    cloth.drag = 2e-3;
    cloth.drag_model = how.drag;
    cloth.spring_damping = 0.02;
    const weft::ClothId id = add(test, sail, how.kind, cloth);
    test.check(test.world().set_wind(
        {to_weft(sail.air.velocity), sail.air.density, sail.air.normal, sail.air.tangential}));
    test.step(1.0 / 60, 300);
    if (!expected) expected = statics(sail.sheet(test.cook(sail.grid())));
    EXPECT_GT(furthest(*expected, sail.at()), 0.1);
    const double within = how.precision == weft::Precision::float64 ? 1e-8 : 3e-5;
    EXPECT_LE(furthest(test.positions(id), *expected), within) << substeps << " substeps";
  }
}

constexpr auto f32 = weft::Precision::float32, f64 = weft::Precision::float64;
constexpr auto summed = weft::Form::summed, position = weft::Form::position;
constexpr auto central = weft::DragModel::central, lagged = weft::DragModel::lagged;
INSTANTIATE_TEST_SUITE_P(
    Variants, SailBalance,
    testing::Values(Balance{"grid", f64, summed, Kind::grid, central},
                    Balance{"position", f64, position, Kind::grid, lagged},
                    Balance{"mesh", f64, summed, Kind::mesh, lagged},
                    Balance{"mesh_position", f64, position, Kind::mesh, central},
                    Balance{"scattered", f64, summed, Kind::scattered, central},
                    Balance{"scattered_position", f64, position, Kind::scattered, lagged},
                    Balance{"single", f32, summed, Kind::grid, central},
                    Balance{"single_mesh", f32, summed, Kind::mesh, lagged}),
    [](const testing::TestParamInfo<Balance>& info) { return std::string(info.param.name); });

using WindStep = BothPrecisions;

/// A flat triangle in the plane across `ahead`, 1 m^2.
Triangles flat() {
  Triangles mesh;
  mesh.vertices = {{0, 0, 0}, across, 2 * beside};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

TEST_P(WindStep, BalancesDragAndGravityAtTheSpeedWhereTheirSumIsZero) {
  // m g = c v + b v^2 for each vertex: m = 0.1 kg/3, b = rho A/6.
  const double g = 9.81, rho = 1.2, mass = 0.1 / 3, b = rho / 6, c = 0.3;
  const double expected = (-c + std::sqrt(c * c + 4 * b * mass * g)) / (2 * b);
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const weft::DragModel model : {central, lagged})
      for (const double dt : {0.02, 0.004}) {
        weft::WorldDesc world = plain_world(GetParam());
        world.form = form;
        world.gravity = to_weft(-g * ahead);
        TestWorld test(world);
        weft::ClothDesc cloth;
        cloth.drag = c;
        cloth.drag_model = model;
        const weft::ClothId id =
            add_mesh_cloth(test, flat(), slack(weft::Mass::Kind::total, 0.1), cloth);
        test.check(test.world().set_wind({{0, 0, 0}, rho, 1, 0}));
        test.step(dt, int(2 / dt));
        const Vec before = test.position(id, 1);
        test.step(dt, 5);
        expect_near((1 / (5 * dt)) * (test.position(id, 1) - before), -expected * ahead,
                    GetParam() == weft::Precision::float64 ? 1e-9 : 1e-6 / dt);
      }
}

TEST_P(WindStep, DecaysAsTheClosedFormWhenTheStepChanges) {
  // w = w0/(1 + b w0 t/m) between the middles of the steps, which are (dt + dt_before)/2 apart.
  const double w0 = 40, rho = 1.2, mass = 0.05, per = rho / 6 / (mass / 3);
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    if (form == weft::Form::position && GetParam() == weft::Precision::float32) continue;
    weft::WorldDesc world = plain_world(GetParam(), weft::Start::lagged);
    world.form = form;
    TestWorld test(world);
    const weft::ClothId id = add_mesh_cloth(test, flat(), slack(weft::Mass::Kind::total, mass));
    test.check(test.world().set_wind({to_weft(w0 * ahead), rho, 1, 0}));
    double w = w0, dt_before = 0.02;
    for (const double dt : {0.02, 0.02, 0.001, 0.05, 0.05, 0.004, 0.1, 0.01, 0.01}) {
      const Vec before = test.position(id, 2);
      test.step(dt);
      w = w / (1 + per * w * (dt + dt_before) / 2);
      dt_before = dt;
      const Vec relative = w0 * ahead - (1 / dt) * (test.position(id, 2) - before);
      expect_near(relative, w * ahead,
                  GetParam() == weft::Precision::float64 ? 1e-9 * w0 : 3e-6 / dt);
    }
  }
}

TEST_P(WindStep, NeverReversesTheRelativeVelocityHoweverTheStepChanges) {
  for (const Vec direction : {ahead, across, 0.6 * ahead + 0.8 * beside})
    for (const double speed : {3.0, 300.0}) {
      TestWorld test(plain_world(GetParam(), weft::Start::lagged));
      const weft::ClothId id = add_mesh_cloth(test, flat(), slack(weft::Mass::Kind::total, 0.01));
      test.check(test.world().set_wind({to_weft(speed * direction), 1.2, 1, 0.7}));
      Vec u = speed * direction;
      for (const double dt : {0.1, 0.001, 0.1, 0.1, 0.002, 0.03, 0.001, 0.001, 0.2}) {
        const Vec before = test.position(id, 0);
        test.step(dt);
        const Vec now = speed * direction - (1 / dt) * (test.position(id, 0) - before);
        const double rounding = 1e-5 * speed + 2e-6 / dt;
        EXPECT_GE(dot(now, u), -rounding * rounding - rounding * length(u)) << speed;
        EXPECT_LE(length(now), length(u) + rounding) << speed;
        u = now;
      }
    }
}

TEST_P(WindStep, NeverReversesWhatAStrongForceLeavesOfTheRelativeVelocity) {
  // w' = (w + dt F/m)/(1 + b |w| dt/m) has the sign of w + dt F/m, however strong the wind.
  const double rho = 1.2, mass = 0.01 / 3, b = rho / 6, dt = 0.01, w0 = 200;
  for (const double force : {-300.0, -1.0, 1.0, 300.0}) {
    TestWorld test(plain_world(GetParam(), weft::Start::lagged));
    weft::ClothDesc cloth;
    std::vector<weft::VertexForce> forces;
    for (uint32_t v = 0; v < 3; ++v) forces.push_back({v, to_weft(-force * ahead)});
    cloth.forces = forces;
    const weft::ClothId id =
        add_mesh_cloth(test, flat(), slack(weft::Mass::Kind::total, 3 * mass), cloth);
    test.check(test.world().set_wind({to_weft(w0 * ahead), rho, 1, 0}));
    double w = w0;
    for (int n = 0; n < 40; ++n) {
      const Vec before = test.position(id, 1);
      test.step(dt);
      w = (w + dt * force / mass) / (1 + b * std::abs(w) * dt / mass);
      const Vec relative = w0 * ahead - (1 / dt) * (test.position(id, 1) - before);
      // Across the wind the rounding of far positions tilts the triangle a little.
      EXPECT_NEAR(dot(relative, ahead), w,
                  GetParam() == weft::Precision::float64 ? 1e-8 * w0 : 2e-4 * w0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, WindStep, both_precisions(), precision_name);

/// Error of weft after `time` in `count` steps.
double error(const Sail& sail, const std::vector<Vec>& expected, double time, int count,
             weft::Form form, bool pinned) {
  weft::WorldDesc world = plain_world(weft::Precision::float64);
  world.form = form;
  world.gravity = to_weft(sail.gravity);
  TestWorld test(world);
  const std::vector<weft::double3> at = to_weft(sail.at());
  std::vector<weft::Pin> pins;
  if (pinned)
    for (const uint32_t pin : sail.border()) pins.push_back({pin, weft::Pin::fixed});
  weft::ClothDesc cloth;
  cloth.positions = weft::View<weft::double3>(at);
  cloth.pins = pins;
  const weft::ClothId id = test.add(sail.grid(), cloth);
  test.check(test.world().set_wind(
      {to_weft(sail.air.velocity), sail.air.density, sail.air.normal, sail.air.tangential}));
  test.step(time / count, count);
  return furthest(test.positions(id), expected);
}

TEST(WindOrder, IsTwoForASheetWhoseVerticesAccelerateAlike) {
  for (const bool along : {false, true}) {  // the slip keeps its direction, or does not matter
    Sail sail;
    sail.density = 0.05;
    if (along) sail.gravity = {};
    sail.air.tangential = along ? 0.5 : 0;
    TestWorld cook;
    reference::WindySheet sheet = sail.sheet(cook.cook(sail.grid()));
    sheet.pinned.assign(sheet.pinned.size(), false);
    const double time = 0.3;
    const std::vector<Vec> expected = sheet.after(time, 6000);
    ASSERT_GT(furthest(expected, sail.at()), 0.5);
    for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
      double previous = error(sail, expected, time, 150, form, false);
      EXPECT_LE(previous, 3e-3);
      for (const int count : {300, 600, 1200}) {
        const double now = error(sail, expected, time, count, form, false);
        EXPECT_NEAR(std::log2(previous / now), 2, 0.25) << along << ' ' << count;
        previous = now;
      }
    }
  }
}

TEST(WindOrder, IsOneWithASmallErrorForASailThatIsHeld) {
  const Sail sail;
  TestWorld cook;
  const double time = 0.25;
  const std::vector<Vec> expected = sail.sheet(cook.cook(sail.grid())).after(time, 6000);
  ASSERT_GT(furthest(expected, sail.at()), 0.1);
  double previous = 0;
  for (const int count : {200, 400, 800}) {
    const double now = error(sail, expected, time, count, weft::Form::summed, true);
    EXPECT_LE(now, 4e-3 * 200 / count) << count;
    if (previous > 0) {
      EXPECT_GE(std::log2(previous / now), 0.75) << count;
    }
    previous = now;
  }
}

}  // namespace
}  // namespace weft_tests
