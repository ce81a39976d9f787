// Lists of near colliders: whoever leaves the region that one was made for meets all, along every
// axis; and a list may be longer than the mask of a block.
#include "reference/effects.h"

namespace weft_tests::collider_lists {
namespace {

constexpr double dt = 1.0 / 60;

using ColliderLists = BothPrecisions;

/// Pushed from rest, through 0.3 m in one step, against a wall that was out of reach. `near`:
/// another collider is within reach, so that blocks have lists of their own.
TEST_P(ColliderLists, WhoLeavesTheRegionMeetsAllAlongEveryAxis) {
  for (const bool near : {false, true})
    for (const Vec axis : {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}})
      for (const double side : {1.0, -1.0}) {
        const Vec way = side * axis;
        SCOPED_TRACE(testing::Message() << way.x << " " << way.y << " " << way.z << " " << near);
        weft::WorldDesc desc;
        desc.precision = GetParam();
        desc.gravity = {0, 0, 0};
        desc.substeps = 40;
        TestWorld test(desc);
        const weft::ClothId cloth =
            add_particles(test, {{0.01, 0.02, 0.03}, {0.02, 0.01, 0.02}}, {}, 1e-3);
        const auto add_box = [&](Vec centre, double half) {
          weft::BoxDesc box;
          box.center = to_weft(centre);
          box.half = {half, half, half};
          test.take(test.world().create_box(box));
        };
        add_box(1.1 * way, 1);  // its face is at 0.1
        if (near) add_box(-0.1 * way, 0.05);
        const weft::VertexForce forces[] = {{0, to_weft(2.2 * way)}, {1, to_weft(2.2 * way)}};
        ASSERT_EQ(test.world().set_forces(cloth, weft::View<weft::VertexForce>(forces, 2)),
                  weft::Status::ok);
        for (int n = 0; n < 2; ++n) {  // in the first step already: nothing is pushed back later
          test.step(dt);
          for (const Vec x : test.positions(cloth)) EXPECT_NEAR(dot(x, way), 0.1, 1e-5) << n;
        }
      }
}

/// Ninety plates side by side, each under a particle of its own.
TEST_P(ColliderLists, TheLastOfNinetyCollidersHoldsToo) {
  weft::WorldDesc desc;
  desc.precision = GetParam();
  TestWorld test(desc);
  std::vector<Vec> at;
  for (int i = 0; i < 90; ++i) at.push_back({0.05 * (i % 10), 0.03, 0.05 * (i / 10)});
  const weft::ClothId cloth = add_particles(test, at);
  for (const Vec x : at) {
    weft::BoxDesc plate;
    plate.center = to_weft(x - Vec{0, 0.04, 0});
    plate.half = {0.01, 0.01, 0.01};
    test.take(test.world().create_box(plate));
  }
  test.step(dt, 20);
  const std::vector<Vec> x = test.positions(cloth);
  for (size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i].y, 0, 1e-6) << "plate " << i;
}

/// A closed mesh lets out what is inside, fast or slow; nothing is stopped at its faces from there.
TEST_P(ColliderLists, AClosedMeshIsNotCrossedFromInside) {
  const double half = 0.1, thickness = 0.01;
  for (const Vec way : {ahead, across, Vec{0, 0, -1}}) {
    TestWorld test(plain_world(GetParam(), weft::Start::lagged));
    const double speed = 60;
    const Vec middle{0.2, 0.1, -0.3};
    const weft::ClothId cloth = add_particles(test, {middle}, speed * way);
    weft::MeshColliderDesc desc;
    desc.pose.translate = to_weft(middle);
    add_collider(test, reference::box({half, half, half}), thickness, true, desc);
    test.step(dt);
    const Vec flown = test.position(cloth, 0) - middle;
    EXPECT_NEAR(dot(flown, way), speed * dt, 0.01) << "it is stopped";
  }
}

/// Coulomb friction of a slide that is so fast that it is swept: v dt n - mu g dt^2 n (n + 1)/2.
TEST_P(ColliderLists, AFastSlideIsBrakedInBothForms) {
  const double mu = 0.3, speed = 6, g = 9.81;
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    weft::WorldDesc desc = plain_world(GetParam(), weft::Start::lagged);
    desc.gravity = {0, -g, 0};
    desc.form = form;
    TestWorld test(desc);
    const weft::ClothId cloth = add_particles(test, {{-0.9, 0, 0.1}}, {speed, 0, 0});
    weft::BoxDesc box;
    box.center = {0, -0.1, 0};
    box.half = {2, 0.1, 2};
    box.friction = mu;
    test.take(test.world().create_box(box));
    for (int n = 1; n <= 15; ++n) {
      test.step(dt);
      const double slid = speed * dt * n - mu * g * dt * dt * n * (n + 1) / 2;
      EXPECT_NEAR(test.position(cloth, 0).x + 0.9, slid, 2e-5 * n) << n << " " << int(form);
      EXPECT_NEAR(test.position(cloth, 0).y, 0, 1e-6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, ColliderLists, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::collider_lists
