// The forces of wind on whole sheets: area terms (HC62), and random triangles against an
// independent reference.
#include "reference/effects.h"
#include "reference/grid.h"
#include "reference/random.h"
#include "reference/wind.h"

namespace weft_tests {
namespace {

using WindForce = BothPrecisions;

weft::WindDesc wind_of(const reference::Air& air) {
  return {to_weft(air.velocity), air.density, air.normal, air.tangential};
}

double relative(weft::Precision precision) {
  return precision == weft::Precision::float64 ? 1e-11 : 3e-5;
}

Vec sum(const std::vector<Vec>& of) {
  Vec all;
  for (const Vec v : of) all += v;
  return all;
}

TEST_P(WindForce, OnAFlatSquareIsTheAreaTermForAnyStencil) {
  const double side = 1.5, mass = 0.01;
  const reference::Air air{{0.5, -2, 7}, 1.225, 1.1, 0};
  for (const weft::Stencil stencil :
       {weft::Stencil::seed12, weft::Stencil::classic12, weft::Stencil::quad4, weft::Stencil::tri6})
    for (const uint32_t n : {2u, 3u, 17u}) {
      weft::GridDesc grid;
      grid.rows = grid.columns = n;
      grid.width = grid.height = side;
      grid.stencil = stencil;
      grid.material = slack(weft::Mass::Kind::total, mass * n * n);
      TestWorld test(plain_world(GetParam()));
      const weft::ClothId cloth = test.add(grid, weft::ClothDesc{});
      test.check(test.world().set_wind(wind_of(air)));
      test.check(test.world().prepare(1e-13));
      const double expected = air.density / 2 * side * side * air.normal * 7 * 7;
      const Vec force = mass * sum(test.accelerations(cloth));
      expect_near(force, {0, 0, expected}, relative(GetParam()) * expected);
    }
}

/// n x n squares, each split by a diagonal that `flip` chooses.
Triangles split_squares(uint32_t n, double side, bool (*flip)(uint32_t, uint32_t)) {
  Triangles mesh;
  mesh.vertices = reference::grid_positions(n + 1, n + 1, side, side);
  for (uint32_t r = 0; r < n; ++r)
    for (uint32_t c = 0; c < n; ++c) {
      const uint32_t a = r * (n + 1) + c, b = a + 1, d = a + n + 1, e = d + 1;
      if (flip(r, c)) {
        mesh.faces.insert(mesh.faces.end(), {{a, b, d}, {b, e, d}});
      } else {
        mesh.faces.insert(mesh.faces.end(), {{a, b, e}, {a, e, d}});
      }
    }
  return mesh;
}

TEST_P(WindForce, OnAFlatSquareIsTheAreaTermForAnyTriangulation) {
  const double side = 1.5, mass = 0.01;
  const reference::Air air{{0.5, -2, 7}, 1.225, 1.1, 0.3};
  const double slip = std::sqrt(0.25 + 4), half = air.density / 2 * side * side;
  const Vec expected = half * Vec{0.3 * slip * 0.5, -0.3 * slip * 2, 1.1 * 49};
  const auto never = [](uint32_t, uint32_t) { return false; };
  const auto chequered = [](uint32_t r, uint32_t c) { return (r + c) % 2 == 0; };
  for (bool (*flip)(uint32_t, uint32_t) : {+never, +chequered}) {
    const Triangles mesh = split_squares(9, side, flip);
    TestWorld test(plain_world(GetParam()));
    const weft::ClothId cloth =
        add_mesh_cloth(test, mesh, slack(weft::Mass::Kind::total, mass * 100));
    test.check(test.world().set_wind(wind_of(air)));
    test.check(test.world().prepare(1e-13));
    const Vec force = mass * sum(test.accelerations(cloth));
    expect_near(force, expected, relative(GetParam()) * length(expected));
  }
}

/// A crumpled sheet whose vertices all move differently, and what acts on it.
struct Crumpled {
  Triangles mesh;
  std::vector<Vec> velocities;
  double mass = 0.002;

  explicit Crumpled(uint64_t seed) {
    mesh = reference::sheet(1, 9, 0.1);
    reference::SplitMix random(seed);
    for (Vec& x : mesh.vertices) {
      x += random.noise(0.02);
      x = reference::through_float(x);
      velocities.push_back(random.noise(2));
    }
  }
  weft::ClothId add_to(TestWorld& test) const {
    const std::vector<weft::double3> v = to_weft(velocities);
    weft::ClothDesc cloth;
    cloth.velocities = v;
    const double total = mass * double(mesh.vertices.size());
    return add_mesh_cloth(test, mesh, slack(weft::Mass::Kind::total, total), cloth);
  }
};

TEST_P(WindForce, OnRandomTrianglesIsThatOfTheReferenceOverTheStep) {
  for (const double dt : {1e-7, 1.0 / 60})
    for (const reference::Air& air :
         {reference::Air{{9, -4, 6}, 1.225, 1, 0.02}, reference::Air{{0, 0, 0}, 1.3, 0.8, 0.6},
          reference::Air{{30, 10, -5}, 0.9, 0, 0.5}, reference::Air{{-3, 1, 2}, 2, 1.4, 0}})
      for (const uint64_t seed : {1u, 2u, 3u}) {
        const Crumpled cloth(seed);
        TestWorld test(plain_world(GetParam(), weft::Start::lagged));
        const weft::ClothId id = cloth.add_to(test);
        test.check(test.world().set_wind(wind_of(air)));
        test.check(test.world().prepare(dt));
        const std::vector<Vec> a = test.accelerations(id);
        const auto expected = reference::wind_forces(cloth.mesh, cloth.velocities, air);
        double most = 0;
        for (const Vec f : expected.force) most = std::max(most, length(f) / cloth.mass);
        for (size_t i = 0; i < a.size(); ++i) {
          const Vec at_once = (1 / cloth.mass) * expected.force[i];
          expect_near(a[i], reference::relaxed(expected.per_velocity[i], dt / cloth.mass, at_once),
                      relative(GetParam()) * most);
        }
      }
}

TEST_P(WindForce, OnAGridIsThatOnTheSameMesh) {
  weft::GridDesc grid;
  grid.rows = 13;
  grid.columns = 10;
  grid.stencil = weft::Stencil::tri6;
  grid.material.stiffness = 20;
  grid.material.mass.value = 0.3;
  weft::WorldDesc world = plain_world(GetParam());
  world.substeps = 4;
  world.gravity = {0, -9.81, 0};
  TestWorld on_grid(world), on_mesh(world);
  const weft::ClothId a = on_grid.add(grid, weft::ClothDesc{});
  const Triangles mesh = triangles_of(on_grid.cook(grid), reference::grid_positions(13, 10));
  const weft::ClothId b = add_mesh_cloth(on_mesh, mesh, grid.material);
  for (TestWorld* test : {&on_grid, &on_mesh}) {
    test->check(test->world().set_wind({{2, 1, 6}, 1.225, 1, 0.1}));
    test->step(1.0 / 60, 3);
  }
  const std::vector<Vec> x = on_grid.positions(a), y = on_mesh.positions(b);
  ASSERT_EQ(x.size(), y.size());
  for (size_t i = 0; i < x.size(); ++i)
    expect_near(x[i], y[i], GetParam() == weft::Precision::float64 ? 1e-10 : 1e-6);
  // Without the rounding of springs the accelerations agree to that of the wind.
  grid.material.stiffness = 0;
  TestWorld first(world), second(world);
  const weft::ClothId c = first.add(grid, weft::ClothDesc{});
  const weft::ClothId d = add_mesh_cloth(second, mesh, grid.material);
  for (TestWorld* test : {&first, &second}) {
    test->check(test->world().set_wind({{2, 1, 6}, 1.225, 1, 0.1}));
    test->check(test->world().prepare(1.0 / 60));
  }
  const std::vector<Vec> p = first.accelerations(c), q = second.accelerations(d);
  double most = 0;
  for (const Vec v : p) most = std::max(most, length(v));
  for (size_t i = 0; i < p.size(); ++i) expect_near(p[i], q[i], 1e-6 * most);
}

INSTANTIATE_TEST_SUITE_P(Precision, WindForce, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
