// What Listing 22.1 of Fratarcangeli 2011 says by the letter and what it means: every test computes
// the literal number, shows that it is another one, and expects the meaning of weft.
#include "reference/closed_forms.h"
#include "reference/literal_listing.h"
#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

using Errata = BothPrecisions;

TEST_P(Errata, StretchedSpringAttracts) {
  const double meant = 0.790801268222;
  ASSERT_NEAR(reference::signed_spring(1, 100, 1, 1, 1.25, 0.01, 100), meant, 1e-11);
  ASSERT_NEAR(reference::signed_spring(-1, 100, 1, 1, 1.25, 0.01, 100), 2742.873, 1e-3);
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = AnchoredMass{}.add_to(test);
  test.step(0.01, 100);
  EXPECT_NEAR(test.position(cloth, 1).x, meant, tolerance(GetParam(), meant));
}

TEST_P(Errata, GravityIsAnAcceleration) {
  ASSERT_NEAR(reference::literal_gravity_drop(0.1, 0.01, 100), 49.05, 1e-10);
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -9.81, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0, 0, 0}}, {}, 0.1);
  test.step(0.01, 100);
  EXPECT_NEAR(test.position(cloth, 0).y, -4.905, tolerance(GetParam(), 4.905));
}

TEST_P(Errata, DragCountsOncePerVertex) {
  // A rest sheet moving as a whole: its corner has 4 neighbours, its middle 12.
  const double b = 0.5, vertex_mass = 0.25, g = 9.81;
  const double weight = vertex_mass * g;
  const double literal_corner = reference::literal_terminal_velocity(weight, b, 4);
  const double literal_middle = reference::literal_terminal_velocity(weight, b, 12);
  ASSERT_NEAR(literal_corner / literal_middle, 3, 1e-12);
  for (weft::DragModel model : {weft::DragModel::lagged, weft::DragModel::central}) {
    Sheet sheet;
    sheet.rows = sheet.columns = 17;
    sheet.vertex_mass = vertex_mass;
    weft::WorldDesc desc = plain_world(GetParam());
    desc.gravity = {0, 0, -g};
    TestWorld test(desc);
    weft::ClothDesc cloth_desc;
    cloth_desc.drag = b;
    cloth_desc.drag_model = model;
    const weft::ClothId cloth = sheet.add_to(test, cloth_desc);
    test.step(0.005, 4000);
    const double terminal = weight / b;
    const std::vector<Vec> v = test.velocities(cloth);
    EXPECT_NEAR(v[0].z, -terminal, tolerance(GetParam(), terminal));
    EXPECT_NEAR(v[8 * 17 + 8].z, -terminal, tolerance(GetParam(), terminal));
    EXPECT_GT(std::abs(v[0].z) - literal_corner, 0.7 * terminal);
  }
}

TEST_P(Errata, GridStartsWithoutTension) {
  const std::vector<reference::Spring> literal = reference::literal_rest_lengths(32, 100);
  const std::vector<Vec> at = reference::grid_positions(32, 32);
  ASSERT_NEAR(length(at[literal[0].b] - at[literal[0].a]) / literal[0].rest, 1.032258065, 1e-9);
  std::vector<Vec> literal_force(1024);
  reference::add_spring_forces(literal, at, literal_force);
  ASSERT_GT(length(literal_force[0]), 0.1);  // the corner is pulled in
  Sheet sheet;
  sheet.rows = sheet.columns = 32;
  sheet.stiffness = 100;
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = test.add(sheet.grid(), weft::ClothDesc{});
  const double quantum = GetParam() == weft::Precision::float64 ? 0x1p-53 : 0x1p-24;
  for (Vec a : test.accelerations(cloth))  // N, each of 12 springs within rounding of lengths < 1
    ASSERT_LE(length(a) * sheet.vertex_mass, 12 * 4 * sheet.stiffness * quantum);
  EXPECT_LE(test.mechanics().elastic, 1e-9);
}

TEST(ErrataIndex, NeighboursAreTheOnesTheStencilNames) {
  const reference::LiteralNeighbours literal = reference::literal_neighbours(32);
  ASSERT_EQ(literal.count, 11412);
  ASSERT_EQ(literal.wrapped, 240);
  ASSERT_EQ(literal.outside_array, 238);
  // One vertex out of the plane pulls on its neighbours and on nobody else.
  for (uint32_t lifted : {0u, 31u, 33u, 992u, 1023u, 500u, 95u, 961u}) {
    Sheet sheet;
    sheet.rows = sheet.columns = 32;
    std::vector<Vec> x = sheet.start();
    x[lifted].z = 0.25;
    std::vector<Vec> expected(1024);
    reference::add_spring_forces(sheet.system().springs, x, expected);
    const std::vector<weft::double3> start = to_weft(x);
    weft::ClothDesc desc;
    desc.positions = weft::View<weft::double3>(start);
    TestWorld test(plain_world(weft::Precision::float64));
    const weft::ClothId cloth = test.add(sheet.grid(), desc);
    const std::vector<Vec> a = test.accelerations(cloth);
    int pulled = 0;
    for (size_t i = 0; i < 1024; ++i) {
      EXPECT_NEAR(a[i].z * sheet.vertex_mass, expected[i].z, 1e-10) << lifted << ' ' << i;
      pulled += a[i].z > 1e-6;
    }
    EXPECT_GE(pulled, 4);
    EXPECT_LE(pulled, 12);
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Errata, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
