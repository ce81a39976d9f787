// Inputs that are taken back, given in frames that drop time, or arrive while somebody sleeps.
#include <cmath>
#include <functional>

#include "reference/world_helpers.h"

namespace weft_tests::inputs_in_time {
namespace {

constexpr weft::double3 axes[] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                  {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
weft::double3 times(double s, weft::double3 v) { return {s * v.x, s * v.y, s * v.z}; }

weft::NetworkDesc one_vertex(const weft::double3& at) {
  weft::NetworkDesc desc;
  desc.positions = weft::View<weft::double3>(&at, 1);
  return desc;
}
weft::WorldDesc still_world() { return plain_world(weft::Precision::float64); }
weft::View<weft::double3> one(const weft::double3& v) { return {&v, 1}; }

struct Box {
  weft::BoxDesc box;
  weft::ColliderSetDesc set() const {
    weft::ColliderSetDesc desc;
    desc.boxes = {&box, 1};
    return desc;
  }
};

TEST(InputsInTime, ATargetThatIsTakenBackMovesNothing) {
  TestWorld test(still_world());
  const weft::double3 home{0.5, -1, 2}, away{3, 4, 5};
  const weft::ClothId cloth = test.add(one_vertex(home), {});
  const uint32_t vertex[] = {0};
  const auto lead = [&](const weft::double3& to) {
    test.check(test.world().move_pins(cloth, {vertex, 1}, one(to)));
  };
  lead(home);
  test.step(0.1);
  lead(away);
  lead(home);
  test.step(0.1);
  expect_near(test.position(cloth, 0), from_weft(home), 0);
  // Half the way there in one step of two, and back in the next frame.
  lead(away);
  test.step(0.1);
  lead(home);
  test.step(0.1);
  expect_near(test.position(cloth, 0), from_weft(home), 1e-15);
}

TEST(InputsInTime, ATeleportEndsTheWayThatWasGiven) {
  TestWorld test(still_world());
  const weft::ClothId cloth = test.add(one_vertex({0, 0, 0}), {});
  weft::SphereDesc sphere;
  sphere.center = {-5, 0, 0};
  sphere.radius = 1;
  const weft::ColliderId id = test.take(test.world().create_sphere(sphere));
  weft::Pose pose;
  pose.translate = {5, 0.5, 0};  // about the vertex
  test.check(test.world().move_collider(id, pose));
  pose.translate = {0, 9, 0};
  test.check(test.world().move_collider(id, pose, weft::Move::teleport));
  test.step(0.1, 3);
  expect_near(test.position(cloth, 0), {0, 0, 0}, 0);
  // It is where it was put: a vertex there is met.
  pose.translate = {5, -0.5, 0};
  test.check(test.world().move_collider(id, pose, weft::Move::teleport));
  test.step(0.1);
  expect_near(test.position(cloth, 0), {0, 0.5, 0}, 1e-12);
}

/// Of 0.0325 s behind 0.005 s that were owed, two steps of 0.01 s are taken and 0.01 s dropped: the
/// frame is as long as 0.0225 s, and its steps end 0.005 s and 0.015 s after its beginning.
TEST(InputsInTime, AFrameThatDropsTimeEndsItsStepsOnTheWayOfWhatIsLeft) {
  weft::WorldDesc desc = still_world();
  desc.fixed_dt = 0.01;
  desc.max_steps_per_advance = 2;
  TestWorld test(desc);
  const weft::ClothId cloth = test.add(one_vertex({0, 0, 0}), {});
  const uint32_t vertex[] = {0};
  const auto lead = [&](double x) {
    const weft::double3 to{x, 0, 0};
    test.check(test.world().move_pins(cloth, {vertex, 1}, one(to)));
  };
  lead(0);
  test.take(test.world().advance(0.005));
  lead(9);
  EXPECT_EQ(test.take(test.world().advance(0.0325)).steps, 2u);
  EXPECT_NEAR(test.position(cloth, 0).x, 9 * 0.015 / 0.0225, 1e-9);
  test.take(test.world().advance(0.0025));  // a step that ends with the frame before
  EXPECT_NEAR(test.position(cloth, 0).x, 9, 1e-9);
}

TEST(InputsInTime, AFailingAdvanceOwesNotEvenWhatWasOwedBefore) {
  weft::WorldDesc desc;
  desc.substeps = 1;
  TestWorld test(desc);
  const weft::ClothId light = test.add(one_vertex({0, 0, 0}), {});
  EXPECT_EQ(test.take(test.world().advance(0.9 / 60)).steps, 0u);
  weft::GridDesc grid;
  grid.rows = grid.columns = 16;
  grid.material.stiffness = 1e5;
  const weft::ClothId stiff = test.add(grid, {});
  EXPECT_EQ(test.world().advance(1.0 / 60).status(), weft::Status::unstable_step);
  test.check(test.world().destroy_cloth(stiff));
  EXPECT_EQ(test.take(test.world().advance(0.5 / 60)).steps, 0u);
  EXPECT_EQ(test.take(test.world().advance(0.5 / 60)).steps, 1u);
  EXPECT_TRUE(test.world().valid(light));
}

/// A step that just fits into max_substeps is as long as asked for.
TEST(InputsInTime, AsManySubstepsAsAreAllowedDropNoTime) {
  weft::GridDesc grid;
  grid.rows = grid.columns = 8;
  grid.material.stiffness = 1e7;
  weft::WorldDesc desc;
  desc.max_substeps = 10;
  TestWorld test(desc);
  test.add(grid, {});
  const double limit = desc.safety * test.world().stability().dt_bound;
  for (const double part : {9.2, 9.9}) {
    const double before = test.world().time();
    test.step(part * limit);
    EXPECT_EQ(test.world().stats().substeps_last, 10u);
    EXPECT_NEAR(test.world().time() - before, part * limit, 1e-12 * limit);
    EXPECT_EQ(test.world().stats().time_dropped, 0);
    EXPECT_EQ(test.world().events().count, 0u);
  }
}

/// A box that grows and moves in one call puts what lies inside of it on its face, along each axis.
TEST(InputsInTime, ABoxOfASetGrowsAlongEveryAxis) {
  for (const weft::double3 axis : axes) {
    TestWorld test(still_world());
    const weft::double3 at = times(0.6, axis);
    const weft::ClothId cloth = test.add(one_vertex(at), {});
    Box b;
    b.box.half = {0.5, 0.5, 0.5};
    const weft::ColliderSetId id = test.take(test.world().create_collider_set(b.set()));
    test.step(0.1);
    expect_near(test.position(cloth, 0), from_weft(at), 0);
    const auto longer = [](double a) { return a == 0 ? 0.5 : 0.7; };
    b.box.half = {longer(axis.x), longer(axis.y), longer(axis.z)};
    weft::ColliderSetDesc set = b.set();
    set.may_stretch = true;
    test.check(test.world().move_collider_set(id, set));
    test.step(0.1);
    expect_near(test.position(cloth, 0), from_weft(times(0.7, axis)), 1e-12);
  }
}

/// Sleeps beside something; `disturb` reaches it, or takes away what it lay on.
bool sleeps_through(weft::double3 at, const weft::ColliderSetDesc& set,
                    const std::function<void(TestWorld&, weft::ColliderSetId)>& disturb) {
  TestWorld test(still_world());
  weft::ClothDesc calm;
  calm.sleep_speed = 0.1;
  calm.sleep_time = 0.1;
  const weft::ClothId cloth = test.add(one_vertex(at), calm);
  const weft::ColliderSetId id = test.take(test.world().create_collider_set(set));
  test.step(0.1, 4);
  EXPECT_TRUE(test.take(test.world().asleep(cloth)));
  disturb(test, id);
  return test.take(test.world().asleep(cloth));
}

TEST(InputsInTime, WhoeverIsReachedByWhatGrowsOrJumpsWakes) {
  for (const weft::double3 axis : axes) {
    Box b;
    b.box.half = {0.5, 0.5, 0.5};
    Box large = b, beside = b, far = b;
    large.box.half = {0.9, 0.9, 0.9};
    beside.box.center = times(0.2, axis);
    far.box.center = times(-0.1, axis);
    const auto give = [](const Box& to, weft::Move how) {
      return [&to, how](TestWorld& test, weft::ColliderSetId id) {
        weft::ColliderSetDesc set = to.set();
        set.may_stretch = true;
        test.check(test.world().move_collider_set(id, set, how));
      };
    };
    const weft::double3 near = times(0.6, axis), on = times(0.5, axis);
    for (const weft::Move how : {weft::Move::simulate, weft::Move::teleport}) {
      EXPECT_FALSE(sleeps_through(near, b.set(), give(large, how))) << "it grows";
      EXPECT_TRUE(sleeps_through(near, b.set(), give(b, how))) << "nothing changes";
    }
    EXPECT_FALSE(sleeps_through(near, b.set(), give(beside, weft::Move::teleport))) << "it comes";
    EXPECT_FALSE(sleeps_through(on, b.set(), give(far, weft::Move::teleport))) << "it goes";
  }
}

TEST(InputsInTime, WhoLiesOnWhatShrinksWakes) {
  for (const weft::double3 axis : axes) {
    Box b, small;
    b.box.half = {0.5, 0.5, 0.5};
    small.box.half = {0.3, 0.3, 0.3};
    EXPECT_FALSE(sleeps_through(times(0.5, axis), b.set(),
                                [&](TestWorld& test, weft::ColliderSetId id) {
                                  weft::ColliderSetDesc set = small.set();
                                  set.may_stretch = true;
                                  test.check(test.world().move_collider_set(id, set));
                                }));
  }
}

/// Whatever its direction, a speed above sleep_speed keeps awake, and one below does not.
TEST(InputsInTime, SpeedAlongEveryAxisKeepsAwake) {
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const weft::double3 axis : axes)
      for (const double speed : {0.05, 0.2}) {
        weft::WorldDesc desc = still_world();
        desc.form = form;
        TestWorld test(desc);
        weft::ClothDesc made;
        made.velocity = times(speed, axis);
        made.sleep_speed = 0.1;
        made.sleep_time = 0.25;
        const weft::ClothId cloth = test.add(one_vertex({0, 0, 0}), made);
        test.step(1.0 / 64, 64);
        EXPECT_EQ(test.take(test.world().asleep(cloth)), speed < 0.1)
            << axis.x << " " << axis.y << " " << axis.z << ": " << speed;
      }
}

/// Bounds are those of the positions in every frame, also in those in which the origin follows.
TEST(InputsInTime, BoundsAreThoseOfThePositionsAlongEveryWay) {
  for (const bool interpolate : {false, true})
    for (const weft::double3 axis : axes) {
      weft::WorldDesc desc = still_world();
      desc.interpolate = interpolate;
      TestWorld test(desc);
      const std::vector<weft::double3> at{{0, 0, 0}, {0.25, 0, 0.125}, {0, 0.5, -0.25}};
      weft::NetworkDesc loose;
      loose.positions = weft::View<weft::double3>(at);
      weft::ClothDesc made;
      made.velocity = times(48, axis);
      const weft::ClothId cloth = test.add(loose, made);
      std::vector<Vec> before = test.positions(cloth);
      for (int n = 0; n < 100; ++n) {
        test.step(1.0 / 64);
        const std::vector<Vec> x = test.positions(cloth);
        Vec low = x[0], high = x[0];
        const auto take = [&](const std::vector<Vec>& points) {
          for (const Vec& p : points) {
            low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y), std::fmin(low.z, p.z)};
            high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y), std::fmax(high.z, p.z)};
          }
        };
        take(x);
        if (interpolate) take(before);
        before = x;
        const weft::Bounds bounds = test.take(test.world().bounds(cloth));
        expect_near(from_weft(bounds.low), low, 1e-12);
        expect_near(from_weft(bounds.high), high, 1e-12);
        if (testing::Test::HasFailure()) return;
      }
    }
}

}  // namespace
}  // namespace weft_tests::inputs_in_time
