// What read_velocities and mechanics say where something holds a vertex.
#include "reference/effects.h"

namespace weft_tests::contact_velocity {
namespace {

constexpr double dt = 1.0 / 60;

using ContactVelocity = BothPrecisions;

weft::WorldDesc world_with(weft::Precision precision, weft::Form form, uint32_t substeps) {
  weft::WorldDesc desc;
  desc.precision = precision;
  desc.form = form;
  desc.substeps = substeps;
  return desc;
}

TEST_P(ContactVelocity, WhatRestsOnAnyShapeHasNone) {
  for (const Body body : every_body)
    for (const weft::Form form : {weft::Form::summed, weft::Form::position})
      for (const uint32_t substeps : {1u, 5u}) {
        SCOPED_TRACE(testing::Message() << name(body) << " " << int(form) << " " << substeps);
        TestWorld test(world_with(GetParam(), form, substeps));
        const Vec top{0.3, 0.2, -0.4};
        const weft::ClothId cloth = add_particles(test, {top + Vec{0, 1e-3, 0}});
        add_body(test, body, top, 0.1, 0.5);
        test.step(dt, 60);
        const Vec before = test.position(cloth, 0);
        test.step(dt);
        ASSERT_EQ(length(test.position(cloth, 0) - before), 0);
        EXPECT_EQ(length(test.velocities(cloth)[0]), 0);
        EXPECT_EQ(test.mechanics().kinetic, 0);
        EXPECT_EQ(test.mechanics().momentum.y, 0);
      }
}

/// On a plane, held down by a stretched spring from below.
TEST_P(ContactVelocity, ASpringsGripIsNoSpeed) {
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    TestWorld test(world_with(GetParam(), form, 0));
    const std::vector<weft::double3> x{{0.1, -0.2, 0.3}, {0.1, 0, 0.3}};
    const std::vector<weft::Spring> springs{{0, 1, 900, 0.05}};
    weft::NetworkDesc network;
    network.positions = weft::View<weft::double3>(x);
    network.springs = springs;
    network.material.mass.value = 1e-3;
    weft::ClothDesc desc;
    const weft::Pin pin{0};
    desc.pins = weft::View<weft::Pin>(&pin, 1);
    const weft::ClothId cloth = test.add(network, desc);
    test.take(test.world().create_plane(weft::PlaneDesc{}));
    test.step(dt, 30);
    EXPECT_LE(length(test.velocities(cloth)[1]), 1e-6);
    EXPECT_LE(test.mechanics().kinetic, 1e-15);
    EXPECT_NEAR(test.mechanics().elastic, 0.5 * 900 * 0.15 * 0.15, 1e-4);
  }
}

TEST_P(ContactVelocity, WhatHangsInATetherHasNone) {
  TestWorld test(world_with(GetParam(), weft::Form::summed, 0));
  const std::vector<weft::double3> x{{0.1, 0.5, 0.3}, {0.1, 0.2, 0.3}};
  const std::vector<weft::Spring> springs{{0, 1, 1, 0.3}};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.springs = springs;
  network.material.mass.value = 1;
  weft::ClothDesc desc;
  desc.tether_scale = 1;
  const weft::Pin pin{0};
  desc.pins = weft::View<weft::Pin>(&pin, 1);
  const weft::ClothId cloth = test.add(network, desc);
  test.step(dt, 60);
  EXPECT_LE(length(test.velocities(cloth)[1]), 1e-6);
}

TEST_P(ContactVelocity, WhoSleepsHasNone) {
  TestWorld test(world_with(GetParam(), weft::Form::summed, 2));
  const std::vector<weft::double3> x{{0, 0.001, 0}, {0.2, 0.001, 0}};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  weft::ClothDesc desc;
  desc.sleep_speed = 0.01;
  desc.sleep_time = 0.1;
  const weft::ClothId cloth = test.add(network, desc);
  const weft::ColliderId floor = test.take(test.world().create_plane(weft::PlaneDesc{}));
  test.step(dt, 60);
  EXPECT_EQ(length(test.velocities(cloth)[0]), 0);
  ASSERT_EQ(test.world().destroy_collider(floor), weft::Status::ok);
  test.step(dt);
  EXPECT_LT(test.velocities(cloth)[1].y, 0) << "awake it falls";
}

/// What lies on a collider goes along with it, also where that is moved from frame to frame.
TEST_P(ContactVelocity, WhatIsCarriedHasTheCarriersVelocity) {
  for (const bool moved : {false, true}) {
    TestWorld test(world_with(GetParam(), weft::Form::summed, 4));
    const Vec top{0.3, 0.2, -0.4}, velocity{0.4, 0.1, -0.2};
    const weft::ClothId cloth = add_particles(test, {top}, velocity);
    const weft::ColliderId box = add_body(test, Body::box, top, 0.1, 5, moved ? Vec{} : velocity);
    for (int frame = 1; frame <= 30; ++frame) {
      weft::Pose pose;
      pose.translate = to_weft((frame * dt) * velocity);
      if (moved) {
        ASSERT_EQ(test.world().move_collider(box, pose), weft::Status::ok);
      }
      test.step(dt);
    }
    EXPECT_LE(length(test.velocities(cloth)[0] - velocity), 1e-4) << moved;
    // It is said as well where the next place is known already.
    weft::Pose next;
    next.translate = {5, 5, 5};
    ASSERT_EQ(test.world().move_collider(box, next), weft::Status::ok);
    EXPECT_LE(length(test.velocities(cloth)[0] - velocity), 1e-4) << moved;
  }
}

/// On a turntable about the vertical through the box's middle: omega x r.
TEST_P(ContactVelocity, WhatIsTurnedHasTheTurntablesVelocity) {
  TestWorld test(world_with(GetParam(), weft::Form::summed, 8));
  const double degrees = 1.5;  // a frame
  const Vec at{0.05, 0, 0.02};
  const weft::ClothId cloth = add_particles(test, {at});
  weft::BoxDesc desc;
  desc.center = {0, -0.1, 0};
  desc.half = {0.1, 0.1, 0.1};
  desc.friction = 50;
  const weft::ColliderId box = test.take(test.world().create_box(desc));
  for (int frame = 1; frame <= 20; ++frame) {
    weft::Pose pose;
    pose.axis = {0, 1, 0};
    pose.degrees = degrees * frame;
    ASSERT_EQ(test.world().move_collider(box, pose), weft::Status::ok);
    test.step(dt);
  }
  const double omega = degrees * 3.14159265358979323846 / 180 / dt;
  const Vec expected = omega * cross(Vec{0, 1, 0}, test.position(cloth, 0));
  EXPECT_LE(length(test.velocities(cloth)[0] - expected), 0.01 * length(expected));
}

/// Where nothing touches, the velocity has the bits that it has without colliders.
TEST_P(ContactVelocity, AColliderElsewhereChangesNoBit) {
  std::vector<Vec> v[2];
  for (const bool with : {false, true}) {
    TestWorld test(world_with(GetParam(), weft::Form::summed, 3));
    const weft::ClothId cloth =
        add_particles(test, {{0, 1, 0}, {0.3, 1.2, 0.1}}, {0.3, 1, 0.2}, 0.7, 0.4);
    if (with) add_body(test, Body::box, {0.1, 0.5, 0}, 0.1);
    test.step(dt, 7);
    v[with] = test.velocities(cloth);
  }
  for (size_t i = 0; i < 2; ++i) EXPECT_EQ(length(v[0][i] - v[1][i]), 0);
}

/// Second order: a particle that falls and slides on a bowl of a moving plane is compared with a
/// hundredth of the step.
TEST_P(ContactVelocity, ASlideDownASphereIsOfSecondOrder) {
  const auto speed_after = [&](uint32_t substeps) {
    TestWorld test(world_with(weft::Precision::float64, weft::Form::summed, substeps));
    weft::SphereDesc sphere;
    sphere.radius = 0.5;
    test.take(test.world().create_sphere(sphere));
    const Vec at{0.5 * std::sin(0.1), 0.5 * std::cos(0.1), 0};
    const weft::ClothId cloth = add_particles(test, {at});
    test.step(0.1, 4);
    // v^2 = 2 g (h0 - h)
    const double fallen = at.y - test.position(cloth, 0).y;
    return length(test.velocities(cloth)[0]) / std::sqrt(2 * 9.81 * fallen);
  };
  const double coarse = speed_after(10) - 1, fine = speed_after(20) - 1;
  EXPECT_LE(std::abs(coarse), 2e-3);
  EXPECT_LE(std::abs(fine), 0.35 * std::abs(coarse) + 1e-6);
}

/// Reading velocities is reading: later steps have the same bits, asleep or awake, with meshes too.
TEST_P(ContactVelocity, ReadingChangesNoBit) {
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    uint64_t hash[2];
    for (const bool reads : {false, true}) {
      TestWorld test(world_with(GetParam(), form, 0));
      weft::GridDesc grid;
      grid.rows = grid.columns = 12;
      grid.width = grid.height = 0.4;
      grid.material.stiffness = 30;
      grid.material.mass.value = 0.1;
      weft::ClothDesc desc;
      desc.pose = {{1, 0, 0}, 90, {0, 0.12, 0}};
      desc.drag = 1e-3;
      desc.sleep_speed = 0.02;
      desc.sleep_time = 0.05;
      const weft::ClothId cloth = test.add(grid, desc);
      add_body(test, Body::mesh, {0.2, 0.1, 0.2}, 0.08, 0.3);
      const weft::ColliderId ball = add_body(test, Body::sphere, {0.1, 0.11, 0.3}, 0.05, 0.1);
      for (int frame = 0; frame < 30; ++frame) {
        weft::Pose pose;
        pose.axis = {0, 1, 0};
        pose.degrees = 2 * frame;
        if (frame < 20) test.world().move_collider(ball, pose);
        test.step(dt);
        if (reads) {
          test.velocities(cloth);
          test.mechanics();
        }
      }
      hash[reads] = test.hash();
    }
    EXPECT_EQ(hash[0], hash[1]) << int(form);
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, ContactVelocity, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::contact_velocity
