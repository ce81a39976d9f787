// Cloths that share a world, or a fabric, do not touch each other by a bit (HC13).
#include "determinism/scenes.h"
#include "reference/effects.h"

#include <algorithm>

namespace weft_tests {
namespace {

using ManyCloths = BothPrecisions;

/// Cloth `which` of a crowd of small sheets and networks of different sizes, places and pins.
weft::ClothId add_one(TestWorld& test, int which) {
  Sheet sheet;
  sheet.rows = 3 + uint32_t(which) % 7;
  sheet.columns = 4 + uint32_t(which) % 5;
  sheet.stencil = weft::Stencil(which % 4);
  sheet.noise = 0.01;
  sheet.seed = uint64_t(which) + 1;
  sheet.pins = {uint32_t(which) % 3};
  weft::ClothDesc desc;
  desc.velocity = {0.1 * which, 0, 0.25};
  desc.drag = which % 3 == 1 ? 0.01 : 0;
  desc.drag_model = which % 2 ? weft::DragModel::lagged : weft::DragModel::central;
  desc.spring_damping = which % 5 == 2 ? 0.02 : 0;
  return which % 3 == 2 ? sheet.add_network_to(test, desc) : sheet.add_to(test, desc);
}
uint32_t vertices_of(int which) { return (3 + uint32_t(which) % 7) * (4 + uint32_t(which) % 5); }

weft::WorldDesc falling(weft::Precision precision,
                        weft::Integrator integrator = weft::Integrator::verlet) {
  weft::WorldDesc desc = plain_world(precision);
  desc.integrator = integrator;
  desc.gravity = {0, -9.81, 0};
  return desc;
}

void expect_each_as_alone(const weft::WorldDesc& desc) {
  const int crowd = 60;
  weft::ContextDesc context = TestWorld::one_thread();
  context.threads = 3;
  TestWorld together(desc, context);
  add_colliders(together);
  std::vector<weft::ClothId> cloths;
  for (int which = 0; which < crowd; ++which) cloths.push_back(add_one(together, which));
  together.step(5e-4, 200);
  for (int which = 0; which < crowd; ++which) {
    TestWorld alone(desc);
    add_colliders(alone);
    const weft::ClothId cloth = add_one(alone, which);
    alone.step(5e-4, 200);
    const std::vector<Vec> a = alone.positions(cloth), va = alone.velocities(cloth);
    const std::vector<Vec> b = together.positions(cloths[size_t(which)], vertices_of(which));
    const std::vector<Vec> vb = together.velocities(cloths[size_t(which)], vertices_of(which));
    for (size_t i = 0; i < a.size(); ++i) {
      ASSERT_TRUE(same_bits(a[i], b[i])) << which << ' ' << i;
      ASSERT_TRUE(same_bits(va[i], vb[i])) << which << ' ' << i;
    }
  }
}

TEST_P(ManyCloths, InOneWorldMoveAsEachAlone) { expect_each_as_alone(falling(GetParam())); }
TEST_P(ManyCloths, OfConstraintsMoveAsEachAlone) {
  expect_each_as_alone(falling(GetParam(), weft::Integrator::xpbd));
}

/// A mesh that flies 80 m, so that its origin has followed it, when another cloth comes and goes:
/// its device memory is made anew, and not a bit of its rest lengths is another.
TEST_P(ManyCloths, ComingAndGoingOnTheWayChangesNoBit) {
  for (const auto integrator : {weft::Integrator::verlet, weft::Integrator::xpbd}) {
    const auto flown = [&](bool with_another) {
      TestWorld test(falling(GetParam(), integrator));
      weft::Material material;
      material.mass.value = 0.2;
      material.stiffness = 40;
      weft::ClothDesc desc;
      desc.pose = {{1, 2, 3}, 31, {0.3, 0.7, 0.2}};
      desc.velocity = {80, 3, 1};
      const weft::ClothId cloth =
          add_mesh_cloth(test, reference::sheet(0.6, 15, 0.1), material, desc);
      test.step(1e-3, 1000);
      const auto vertices = static_cast<uint32_t>(test.positions(cloth).size());
      if (with_another) test.check(test.world().destroy_cloth(add_one(test, 3)));
      test.step(1e-3, 50);
      return test.positions(cloth, vertices);
    };
    const std::vector<Vec> alone = flown(false), met = flown(true);
    for (size_t i = 0; i < alone.size(); ++i) ASSERT_TRUE(same_bits(alone[i], met[i])) << i;
  }
}

TEST_P(ManyCloths, CreatingAndDestroyingOthersChangesNoBit) {
  TestWorld alone(falling(GetParam())), busy(falling(GetParam()));
  const weft::ClothId a = add_one(alone, 5), b = add_one(busy, 5);
  std::vector<weft::ClothId> others;
  for (int n = 0; n < 50; ++n) {
    if (n % 3 == 0) others.push_back(add_one(busy, n));
    if (n % 7 == 6) {
      busy.check(busy.world().destroy_cloth(others.back()));
      others.pop_back();
    }
    alone.step(5e-4, 2);
    busy.step(5e-4, 2);
    const std::vector<Vec> x = alone.positions(a), y = busy.positions(b, vertices_of(5));
    for (size_t i = 0; i < x.size(); ++i) ASSERT_TRUE(same_bits(x[i], y[i])) << n << ' ' << i;
  }
}

TEST_P(ManyCloths, ShareAFabric) {
  TestWorld test(falling(GetParam())), single(falling(GetParam()));
  Sheet sheet;
  const weft::Fabric fabric = test.cook(sheet.grid());
  weft::ClothDesc desc;
  desc.fabric = fabric;
  const weft::ClothId first = test.add(desc);
  desc.velocity = {1, 0, 0};
  test.add(desc);
  const weft::ClothId alone = single.add(sheet.grid(), weft::ClothDesc{});
  test.step(5e-4, 100);
  single.step(5e-4, 100);
  const std::vector<Vec> x = test.positions(first, 64), y = single.positions(alone);
  for (size_t i = 0; i < x.size(); ++i) ASSERT_TRUE(same_bits(x[i], y[i])) << i;
}

TEST_P(ManyCloths, TwoCopiesInOneNetworkMoveAsOne) {
  Sheet sheet;
  sheet.noise = 0.01;
  NetworkParts one;
  one.masses = {sheet.vertex_mass};
  one.pins = {0};
  one.positions = sheet.start();
  const reference::System system = sheet.system();
  for (const reference::Spring& s : system.springs)
    one.springs.push_back({s.a, s.b, s.stiffness, s.rest});
  NetworkParts two = one;
  two.pins.push_back(64);
  for (Vec p : one.positions) two.positions.push_back(p);
  for (weft::Spring s : one.springs) {
    s.a += 64;
    s.b += 64;
    two.springs.push_back(s);
  }
  TestWorld single(falling(GetParam())), twice(falling(GetParam()));
  const weft::ClothId a = add_network(single, one), b = add_network(twice, two);
  single.step(5e-4, 200);
  twice.step(5e-4, 200);
  const std::vector<Vec> x = single.positions(a), y = twice.positions(b);
  for (size_t i = 0; i < 128; ++i) ASSERT_TRUE(same_bits(x[i % 64], y[i])) << i;
}

TEST_P(ManyCloths, SpringOrderAndDirectionDoNotMatter) {
  Sheet sheet;
  sheet.noise = 0.01;
  NetworkParts forward;
  forward.masses = {sheet.vertex_mass};
  forward.positions = sheet.start();
  const reference::System system = sheet.system();
  for (const reference::Spring& s : system.springs)
    forward.springs.push_back({s.a, s.b, s.stiffness, s.rest});
  NetworkParts backward = forward;
  std::reverse(backward.springs.begin(), backward.springs.end());
  for (weft::Spring& s : backward.springs) std::swap(s.a, s.b);
  TestWorld a(falling(GetParam())), b(falling(GetParam()));
  add_network(a, forward);
  add_network(b, backward);
  a.step(5e-4, 200);
  b.step(5e-4, 200);
  EXPECT_EQ(a.hash(), b.hash());
}

INSTANTIATE_TEST_SUITE_P(Precision, ManyCloths, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
