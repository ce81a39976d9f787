// Layers of colliders: a cloth moves, to the bit, as in a world that has only those which it may
// meet, in their order.
#include "reference/effects.h"
#include "reference/random.h"

namespace weft_tests::collider_layers {
namespace {

constexpr double dt = 1.0 / 60;

using Variant = std::tuple<weft::Precision, weft::Form>;
class ColliderLayers : public testing::TestWithParam<Variant> {
 protected:
  weft::WorldDesc desc() const {
    weft::WorldDesc world;
    std::tie(world.precision, world.form) = GetParam();
    world.substeps = 16;
    return world;
  }
};

/// A level sheet of 20 x 20 about `middle`, a grid or a network.
weft::ClothId add_sheet(TestWorld& test, uint32_t layers, Vec middle, bool network) {
  weft::ClothDesc cloth;
  cloth.collision_layers = layers;
  cloth.drag = 1e-4;
  if (network) {
    NetworkParts parts;
    parts.masses = {1e-3};
    for (uint32_t v = 0; v < 400; ++v) {
      parts.positions.push_back(middle + Vec{0.05 * (v % 20) - 0.5, 0, 0.05 * (v / 20) - 0.5});
      if (v % 20 > 0) parts.springs.push_back({v - 1, v, 20, -1});
      if (v >= 20) parts.springs.push_back({v - 20, v, 20, -1});
    }
    return add_network(test, parts, cloth);
  }
  weft::GridDesc grid;
  grid.rows = grid.columns = 20;
  grid.material.stiffness = 20;
  grid.material.mass.value = 0.4;
  cloth.pose = {{1, 0, 0}, 90, to_weft(middle + Vec{-0.5, 0, -0.5})};
  return test.add(grid, cloth);
}

/// What is under the sheets: of every shape, still, moving and turning, on layers 1, 2, 3 and 4.
struct Under {
  uint32_t layers;
  Body body;
  Vec top;
  double size;
  bool moves, turns;
};
std::vector<Under> all_under() {
  std::vector<Under> found;
  reference::SplitMix random(5);
  for (int i = 0; i < 72; ++i) {
    const Vec at = random.noise(0.5);
    const Body body = every_body[i % 6];
    const double top = body == Body::plane ? -0.25 - 0.01 * (i % 4) : -0.1 + 0.1 * at.y;
    found.push_back(
        {1u + i % 4, body, {at.x, top, at.z}, 0.05 + 0.02 * (i % 3), i % 5 == 1, i % 7 == 2});
  }
  return found;
}

weft::ColliderId add_on(TestWorld& test, const Under& u) {
  const Vec velocity = u.moves ? Vec{0.3, 0.2, -0.1} : Vec{};
  return add_body(test, u.body, u.top, u.size, 0.3, velocity, u.layers);
}

/// Positions of a sheet after each frame, in a world with those colliders that `keep` names.
template <class Keep>
std::vector<Vec> path(TestWorld& test, weft::ClothId cloth, const std::vector<Under>& under,
                      Keep keep) {
  std::vector<weft::ColliderId> turning;
  for (const Under& u : under) {
    if (!keep(u)) continue;
    const weft::ColliderId id = add_on(test, u);
    if (u.turns) turning.push_back(id);
  }
  std::vector<Vec> all;
  for (int frame = 1; frame <= 24; ++frame) {
    for (const weft::ColliderId id : turning) {
      const weft::Pose pose{{0.1, 1, 0.2}, 2.0 * frame, {0.002 * frame, 0, 0}};
      test.check(test.world().move_collider(id, pose));
    }
    test.step(dt);
    const std::vector<Vec> x = test.positions(cloth, 400);
    all.insert(all.end(), x.begin(), x.end());
  }
  return all;
}

TEST_P(ColliderLayers, EachOfThreeClothsMovesAsAmongItsOwnColliders) {
  const std::vector<Under> under = all_under();
  const uint32_t layers[] = {1, 2, 4};
  for (int which = 0; which < 3; ++which) {
    const Vec middle{0.01 * which, 0.02, 0};
    TestWorld all(desc()), own(desc()), none(desc());
    weft::ClothId cloth;
    for (int c = 0; c < 3; ++c) {
      const weft::ClothId id = add_sheet(all, layers[c], {0.01 * c, 0.02, 0}, c == 1);
      if (c == which) cloth = id;
    }
    const auto kept = [&](const Under& u) { return (u.layers & layers[which]) != 0; };
    const std::vector<Vec> found = path(all, cloth, under, [](const Under&) { return true; });
    const std::vector<Vec> expected =
        path(own, add_sheet(own, ~0u, middle, which == 1), under, kept);
    const std::vector<Vec> free = path(none, add_sheet(none, 0, middle, which == 1), under,
                                       [](const Under&) { return true; });
    size_t moved = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      ASSERT_TRUE(same_bits(found[i], expected[i]))
          << "cloth " << which << " frame " << i / 400 << " vertex " << i % 400;
      moved += !same_bits(found[i], free[i]);
    }
    EXPECT_GT(moved, 1000u) << "nothing is met";
    for (size_t i = free.size() - 400; i < free.size(); ++i) EXPECT_LT(free[i].y, -0.7);
  }
}

/// From outside of the region of every list, where a block looks at all colliders.
TEST_P(ColliderLayers, WhoLeavesItsRegionMeetsNoneThatIsMasked) {
  for (const bool near : {false, true}) {
    TestWorld test(desc());
    const weft::ClothId through = add_particles(test, {{0.01, 0.02, 0.03}, {0.02, 0.01, 0.02}});
    weft::ClothDesc layered;
    layered.collision_layers = 2;
    NetworkParts parts;
    parts.positions = {{0.01, 0.02, 0.33}, {0.02, 0.01, 0.32}};
    parts.masses = {1};
    const weft::ClothId masked = add_network(test, parts, layered);
    weft::BoxDesc wall;
    wall.layers = 1;
    wall.center = {1.1, 0, 0};
    test.take(test.world().create_box(wall));
    wall.layers = ~0u;
    wall.center = {-0.2, 0, 0.2};
    wall.half = {0.1, 1, 1};
    if (near) test.take(test.world().create_box(wall));
    test.check(test.world().set_gravity({0, 0, 0}));
    for (const weft::ClothId cloth : {through, masked}) {
      const weft::VertexForce forces[] = {{0, {2000, 0, 0}}, {1, {2000, 0, 0}}};
      test.check(test.world().set_forces(cloth, weft::View<weft::VertexForce>(forces, 2)));
    }
    test.step(dt, 2);
    for (const Vec x : test.positions(through, 2)) EXPECT_NEAR(x.x, 0.1, 1e-5);
    const double flown = (2 * dt) * (2 * dt) / 2 * 2000;  // exact from a Taylor start
    EXPECT_NEAR(test.positions(masked, 2)[0].x, 0.01 + flown, 1e-5);
  }
}

TEST_P(ColliderLayers, ASetHasThemToo) {
  TestWorld test(desc());
  const weft::ClothId meets = add_sheet(test, 6, {0, 0.01, 0}, false);
  const weft::ClothId passes = add_sheet(test, 8, {0, 0.01, 0}, false);
  std::vector<weft::CapsuleDesc> capsules(2);
  for (int i = 0; i < 2; ++i) {
    capsules[i].a = {-2, -0.1, 0.3 * i};
    capsules[i].b = {2, -0.1, 0.3 * i};
    capsules[i].radius = 0.1;
    capsules[i].layers = 2u << i;
  }
  weft::ColliderSetDesc set;
  set.capsules = capsules;
  const auto id = test.take(test.world().create_collider_set(set));
  for (int frame = 0; frame < 20; ++frame) {
    for (weft::CapsuleDesc& c : capsules) {
      c.a.y = c.b.y = c.a.y + 0.001;
      c.layers = 8;  // of a set that moves they are not read
    }
    test.check(test.world().move_collider_set(id, set));
    test.step(dt);
  }
  double nearest = 1e300, lowest = 0;
  for (const Vec x : test.positions(meets))
    for (const weft::CapsuleDesc& c : capsules)
      nearest = std::fmin(nearest, std::hypot(x.y - c.a.y, x.z - c.a.z));
  for (const Vec x : test.positions(passes)) lowest = std::fmin(lowest, x.y);
  EXPECT_NEAR(nearest, 0.1, 1e-5);
  for (const Vec x : test.positions(passes)) EXPECT_LT(x.y, -0.4);
}

TEST_P(ColliderLayers, WakeNoSleeperThatIsMasked) {
  for (const uint32_t layers : {1u, 2u}) {
    weft::WorldDesc world = desc();
    world.gravity = {0, 0, 0};
    TestWorld test(world);
    weft::GridDesc grid;
    grid.rows = grid.columns = 9;
    weft::ClothDesc cloth;
    cloth.collision_layers = 2;
    cloth.sleep_speed = 0.01;
    cloth.sleep_time = 0;
    const weft::ClothId id = test.add(grid, cloth);
    const auto asleep = [&] { return test.take(test.world().asleep(id)); };
    test.step(dt, 3);
    ASSERT_TRUE(asleep());
    weft::SphereDesc sphere;
    sphere.center = {0.5, 0.5, 0};
    sphere.radius = 0.2;
    sphere.layers = layers;
    const weft::ColliderId collider = test.take(test.world().create_sphere(sphere));
    EXPECT_EQ(asleep(), layers == 1) << "by its creation";
    if (layers != 1) continue;
    weft::Pose pose;
    pose.translate = {0.1, 0, 0.05};
    test.check(test.world().move_collider(collider, pose));
    test.step(dt, 2);
    EXPECT_TRUE(asleep()) << "by its motion";
    test.check(test.world().destroy_collider(collider));
    test.step(dt);
    EXPECT_TRUE(asleep()) << "by its end";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Precision, ColliderLayers,
    testing::Combine(testing::Values(weft::Precision::float32, weft::Precision::float64),
                     testing::Values(weft::Form::summed, weft::Form::position)));

}  // namespace
}  // namespace weft_tests::collider_layers
