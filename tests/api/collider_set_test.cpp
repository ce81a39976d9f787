// Colliders sent whole: a set moved to other descriptions is where colliders of those descriptions
// are.
#include <cmath>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

/// Everything a set can hold, turned by `angle` degrees about the y axis through the origin and
/// moved by `by`; each under its own part of the sheet.
struct Everything {
  Everything(double angle, weft::double3 by) {
    const double c = std::cos(angle * 0.017453292519943295);
    const double s = std::sin(angle * 0.017453292519943295);
    const auto put = [&](double x, double y, double z) {
      return weft::double3{c * x + s * z + by.x, y + by.y, -s * x + c * z + by.z};
    };
    for (int i = 0; i < 3; ++i) {
      weft::SphereDesc sphere;
      sphere.center = put(0.15 * i, -0.1, 0.3);
      sphere.radius = 0.08;
      spheres.push_back(sphere);
    }
    weft::PlaneDesc plane;
    plane.normal = {0.1 * c, 1, -0.1 * s};
    plane.offset = -0.3 * std::sqrt(1.01);
    const double size = std::sqrt(1.01);
    plane.offset = (-0.3 + (plane.normal.x * by.x + by.y + plane.normal.z * by.z)) / size;
    planes.push_back(plane);
    weft::CapsuleDesc capsule;
    capsule.a = put(-0.4, -0.05, -0.3);
    capsule.b = put(-0.1, -0.12, -0.1);
    capsule.radius = 0.05;
    capsule.friction = 0.3;
    capsules.push_back(capsule);
    weft::CylinderDesc cylinder;
    cylinder.a = put(0.3, -0.2, -0.3);
    cylinder.b = put(0.3, -0.04, -0.2);
    cylinder.radius = 0.1;
    cylinders.push_back(cylinder);
    weft::BoxDesc box;
    box.center = put(-0.2, -0.12, 0.2);
    box.half = {0.1, 0.05, 0.07};
    box.axis = {0, 1, 0};
    box.degrees = angle + 30;
    boxes.push_back(box);
  }
  weft::ColliderSetDesc desc() const {
    weft::ColliderSetDesc d;
    d.spheres = spheres;
    d.planes = planes;
    d.capsules = capsules;
    d.cylinders = cylinders;
    d.boxes = boxes;
    return d;
  }
  std::vector<weft::SphereDesc> spheres;
  std::vector<weft::PlaneDesc> planes;
  std::vector<weft::CapsuleDesc> capsules;
  std::vector<weft::CylinderDesc> cylinders;
  std::vector<weft::BoxDesc> boxes;
};

/// A level sheet that falls on what is below.
class Falling {
 public:
  Falling() : test(wide()) {
    weft::GridDesc grid;
    grid.rows = grid.columns = 25;
    weft::ClothDesc cloth;
    cloth.pose.degrees = -90;
    cloth.pose.translate = {-0.5, 0.02, 0.5};
    id = test.add(grid, cloth);
  }
  static weft::WorldDesc wide() {
    weft::WorldDesc desc;
    desc.precision = weft::Precision::float64;
    return desc;
  }
  double furthest_from(Falling& other) {
    const std::vector<Vec> a = test.positions(id), b = other.test.positions(other.id);
    double most = 0;
    for (size_t v = 0; v < a.size(); ++v) {
      const Vec d = a[v] - b[v];
      most = std::max(most, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
    }
    return most;
  }
  TestWorld test;
  weft::ClothId id;
};

TEST(ColliderSets, TeleportedIsCreatedThere) {
  for (const double angle : {0.0, 25.0, 180.0, -170.0}) {
    Falling moved, made, bare;
    const Everything from(0, {0, 0, 0}), to(angle, {0.02, -0.03, 0.01});
    const auto set = moved.test.take(moved.test.world().create_collider_set(from.desc()));
    moved.test.check(moved.test.world().move_collider_set(set, to.desc(), weft::Move::teleport));
    made.test.take(made.test.world().create_collider_set(to.desc()));
    moved.test.step(1.0 / 60, 20);
    made.test.step(1.0 / 60, 20);
    bare.test.step(1.0 / 60, 20);
    EXPECT_LT(moved.furthest_from(made), 1e-7) << angle;
    EXPECT_GT(moved.furthest_from(bare), 0.1) << "nothing was touched";
  }
}

TEST(ColliderSets, MoveAsCollidersWithAVelocityDo) {
  Falling sent, own;
  const double dt = 1.0 / 60;
  Everything now(0, {0, 0, 0});
  const auto set = sent.test.take(sent.test.world().create_collider_set(now.desc()));
  for (auto* d : {&now.spheres[0], &now.spheres[1], &now.spheres[2]}) d->velocity = {0, 0.6, 0.1};
  now.planes[0].velocity = now.capsules[0].velocity = {0, 0.6, 0.1};
  now.cylinders[0].velocity = now.boxes[0].velocity = {0, 0.6, 0.1};
  own.test.take(own.test.world().create_collider_set(now.desc()));
  for (int i = 1; i <= 8; ++i) {
    const Everything next(0, {0, 0.6 * i * dt, 0.1 * i * dt});
    sent.test.check(sent.test.world().move_collider_set(set, next.desc()));
    sent.test.step(dt);
    own.test.step(dt);
  }
  EXPECT_LT(sent.furthest_from(own), 1e-7);
  Falling bare;
  bare.test.step(dt, 8);
  EXPECT_GT(sent.furthest_from(bare), 0.02);
}

TEST(ColliderSets, WhatIsRefusedMovesNothing) {
  Falling test, still;
  const Everything from(0, {0, 0, 0}), to(10, {0, 0.1, 0});
  weft::World& world = test.test.world();
  const auto set = test.test.take(world.create_collider_set(from.desc()));
  still.test.take(still.test.world().create_collider_set(from.desc()));
  const auto refused = [&](const weft::ColliderSetDesc& desc, const char* said) {
    test.test.clear_log();
    EXPECT_EQ(world.move_collider_set(set, desc), weft::Status::invalid_argument);
    EXPECT_NE(test.test.log().find(said), std::string::npos) << test.test.log();
  };
  weft::ColliderSetDesc desc = to.desc();
  desc.boxes = {};
  refused(desc, "7 colliders");
  Everything changed = to;
  changed.spheres[2].radius = 0.1;
  refused(changed.desc(), "spheres[2]: the radius is 0.1 m (it was 0.08 m");
  changed = to;
  changed.capsules[0].b.y += 0.1;
  refused(changed.desc(), "capsules[0]: the length");
  changed = to;
  changed.boxes[0].half.y = 0.06;
  refused(changed.desc(), "boxes[0]: the half edge along y");
  changed = to;
  changed.cylinders[0].radius = -1;
  refused(changed.desc(), "cylinders[0]:");
  desc = to.desc();
  desc.planes.data = nullptr;
  refused(desc, "planes");
  desc = to.desc();
  desc.spheres.stride = 16;
  refused(desc, "spheres has a stride of 16 bytes");
  EXPECT_EQ(world.create_collider_set(changed.desc()).status(), weft::Status::invalid_argument);
  test.test.step(1.0 / 60, 10);
  still.test.step(1.0 / 60, 10);
  EXPECT_EQ(test.test.hash(), still.test.hash());
}

TEST(ColliderSets, GoAsAWhole) {
  Falling test, bare;
  const Everything all(0, {0, 0, 0});
  const auto set = test.test.take(test.test.world().create_collider_set(all.desc()));
  test.test.check(test.test.world().destroy_collider_set(set));
  EXPECT_EQ(test.test.world().destroy_collider_set(set), weft::Status::invalid_handle);
  EXPECT_EQ(test.test.world().move_collider_set(set, all.desc()), weft::Status::invalid_handle);
  test.test.step(1.0 / 60, 15);
  bare.test.step(1.0 / 60, 15);
  EXPECT_EQ(test.test.hash(), bare.test.hash());
}

TEST(SkinnedTargets, MoveThePinsAndNothingElse) {
  TestWorld skinned, moved;
  weft::GridDesc grid;
  grid.rows = grid.columns = 12;
  const weft::Pin pins[] = {{3}, {40}, {143}};
  weft::ClothDesc cloth;
  cloth.pins = {pins, 3};
  const weft::ClothId a = skinned.add(grid, cloth), b = moved.add(grid, cloth);
  std::vector<weft::float3> targets(144);
  for (uint32_t v = 0; v < 144; ++v) targets[v] = {float(v) / 100, 0.25f, 0.5f};
  const uint32_t vertices[] = {3, 40, 143};
  const weft::float3 places[] = {targets[3], targets[40], targets[143]};
  for (int i = 0; i < 3; ++i) {
    skinned.check(skinned.world().set_skinned_targets(a, weft::View<weft::float3>(targets)));
    moved.check(moved.world().move_pins(b, {vertices, 3}, weft::View<weft::float3>(places, 3)));
    skinned.step(1.0 / 60);
    moved.step(1.0 / 60);
  }
  EXPECT_EQ(skinned.hash(), moved.hash());
  EXPECT_NEAR(skinned.position(a, 40).x, 0.4, 1e-6);
  targets.pop_back();
  EXPECT_EQ(skinned.world().set_skinned_targets(a, weft::View<weft::float3>(targets)),
            weft::Status::invalid_argument);
  EXPECT_EQ(skinned.world().set_skinned_targets(a, weft::View<weft::float3>(nullptr, 144)),
            weft::Status::invalid_argument);
  targets.push_back({0, 0, 0});
  EXPECT_EQ(
      skinned.world().set_skinned_targets(a, weft::View<weft::float3>(targets.data(), 144, 8)),
      weft::Status::invalid_argument);
  EXPECT_NE(skinned.log().find("a stride of 8 bytes"), std::string::npos);
}

TEST(ProfilerHook, SeesBalancedZonesOfEveryKind) {
  struct Seen {
    std::vector<std::string> open, all;
    bool balanced = true;
  } seen;
  weft::ContextDesc desc = TestWorld::one_thread();
  desc.profiler.user = &seen;
  desc.profiler.zone_begin = [](void* user, const char* name) -> void* {
    auto& s = *static_cast<Seen*>(user);
    s.open.push_back(name);
    s.all.push_back(name);
    return reinterpret_cast<void*>(s.open.size());
  };
  desc.profiler.zone_end = [](void* user, void* zone) {
    auto& s = *static_cast<Seen*>(user);
    s.balanced &= s.open.size() == reinterpret_cast<size_t>(zone);
    s.open.pop_back();
  };
  TestWorld test({}, desc);
  weft::GridDesc grid;
  std::vector<weft::float3> out(4);
  weft::OutputDesc output;
  output.layout.position = {weft::Format::f32x3, 0, 12};
  output.memory = out.data();
  test.take(test.world().bind_output(test.add(grid, {}), output));
  test.step(1.0 / 60);
  test.check(test.world().write_outputs());
  EXPECT_TRUE(seen.balanced);
  EXPECT_TRUE(seen.open.empty());
  const std::vector<std::string> wanted = {"weft cook", "weft prepare", "weft step",
                                           "weft write_outputs"};
  EXPECT_EQ(seen.all, wanted);
  desc.profiler.zone_end = nullptr;
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
}

}  // namespace
}  // namespace weft_tests
