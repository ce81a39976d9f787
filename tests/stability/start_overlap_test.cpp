// Sheets that overlap colliders at the start, or when one is put into them.
#include "reference/effects.h"

namespace weft_tests::start_overlap {
namespace {

constexpr double dt = 1.0 / 60, size = 0.12;
constexpr uint32_t n = 18;
constexpr double side = 0.85, spacing = side / (n - 1);

using StartOverlap = BothPrecisions;

weft::ClothId add_sheet(TestWorld& test) {
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.width = grid.height = side;
  grid.stencil = weft::Stencil::tri6;
  grid.material.stiffness = 800;
  grid.material.mass.value = 0.2;
  weft::ClothDesc desc;
  desc.drag = 2e-4;
  const std::vector<weft::Pin> pins{{0}, {n - 1}, {n * (n - 1)}, {n * n - 1}};
  desc.pins = pins;
  return test.add(grid, desc);
}

weft::WorldDesc world_with(weft::Precision precision, weft::Form form, double safety) {
  weft::WorldDesc desc;
  desc.precision = precision;
  desc.form = form;
  desc.safety = safety;
  return desc;
}

double energy(TestWorld& test) {
  const weft::Mechanics m = test.mechanics();
  return m.kinetic + m.elastic + m.potential;
}

bool told(TestWorld& test, weft::EventType type) {
  bool found = false;
  const weft::View<weft::Event> events = test.world().events();
  for (uint32_t i = 0; i < events.count; ++i) found |= events[i].type == type;
  return found;
}

/// In the middle of the sheet, whose plane cuts it in two.
weft::ColliderId put(TestWorld& test, Body body) {
  return add_body(test, body, {side / 2, side / 2 + size, 0.003}, size);
}

TEST_P(StartOverlap, NoMoreEnergyThanTheWayOutPutIn) {
  for (const Body body : every_body)
    for (const weft::Form form : {weft::Form::summed, weft::Form::position})
      for (const bool teleported : {false, true}) {
        if (body == Body::plane) continue;  // nothing is left of the sheet
        SCOPED_TRACE(testing::Message()
                     << name(body) << ", form " << int(form) << " " << teleported);
        TestWorld test(world_with(GetParam(), form, 0.4));
        add_sheet(test);
        const weft::ColliderId collider = put(test, body);
        if (teleported) {
          weft::Pose away, here;
          away.translate = {0, 0, 9};
          ASSERT_EQ(test.world().move_collider(collider, away, weft::Move::teleport),
                    weft::Status::ok);
          test.step(dt, 3);
          if (body == Body::mesh) here.translate = {side / 2, side / 2, 0.003};
          ASSERT_EQ(test.world().move_collider(collider, body == Body::mesh ? weft::Pose{} : here,
                                               weft::Move::teleport),
                    weft::Status::ok);
        }
        test.step(dt);
        // Two neighbours go out by `size` at most, and the corners of a box across.
        const double widest = (2 * size * std::sqrt(2.0) + 2 * spacing) / spacing;
        EXPECT_LE(test.mechanics().stretch, widest);
        const double first = energy(test);
        for (int frame = 0; frame < 90; ++frame) {
          test.step(dt);
          ASSERT_LE(energy(test), 1.05 * first) << frame;
        }
        EXPECT_LE(test.mechanics().stretch, widest);
      }
}

/// The way out is no speed, in either form: an alone particle deep inside.
TEST_P(StartOverlap, ParticlesDeepInsideComeOutAtRest) {
  for (const Body body : every_body)
    for (const weft::Form form : {weft::Form::summed, weft::Form::position})
      for (const double depth : {0.2, 0.5, 0.9}) {
        SCOPED_TRACE(testing::Message() << name(body) << ", form " << int(form) << " " << depth);
        weft::WorldDesc desc = world_with(GetParam(), form, 0.9);
        desc.gravity = {0, 0, 0};
        desc.substeps = 10;
        TestWorld test(desc);
        const Vec top{0.3, -0.2, 0.5};
        const weft::ClothId cloth = add_particles(test, {top - Vec{0, depth * size, 0}});
        add_body(test, body, top, size);
        test.step(dt);
        const Vec out = test.position(cloth, 0);
        EXPECT_NEAR(out.y, top.y, 1e-5);
        test.step(dt);
        EXPECT_LE(length(test.position(cloth, 0) - out), 2e-3 * size);
      }
}

/// Two that overlap each other and the sheet, and a free sheet on a capsule.
TEST_P(StartOverlap, TwoAtOnceAndAFreeSheetStayCalm) {
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    TestWorld test(world_with(GetParam(), form, 0.4));
    add_sheet(test);
    put(test, Body::sphere);
    add_body(test, Body::capsule, {side / 2 + 0.07, side / 2 + size, 0.02}, size);
    test.step(dt, 2);
    const double first = energy(test);
    for (int frame = 0; frame < 60; ++frame) {
      test.step(dt);
      ASSERT_LE(energy(test), 1.05 * first) << frame;
    }
  }
  TestWorld test(world_with(GetParam(), weft::Form::summed, 0.4));
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.width = grid.height = side;
  grid.material.stiffness = 800;
  grid.material.mass.value = 0.2;
  test.add(grid, {});
  put(test, Body::capsule);
  test.step(dt);
  const double first = energy(test);
  for (int frame = 0; frame < 30; ++frame) {
    test.step(dt);
    ASSERT_LE(energy(test), 1.05 * first) << frame;
  }
}

/// What still gains is told, once, with the spring; the calm say nothing.
TEST_P(StartOverlap, WhatGainsEnergyIsAnEvent) {
  int stretches = 0, energies = 0;
  TestWorld test(world_with(GetParam(), weft::Form::summed, 1));
  const weft::ClothId sheet = add_sheet(test);
  put(test, Body::capsule);
  for (int frame = 0; frame < 90; ++frame) {
    test.step(dt);
    stretches += told(test, weft::EventType::large_stretch);
    energies += told(test, weft::EventType::energy_growth);
    const weft::View<weft::Event> events = test.world().events();
    for (uint32_t i = 0; i < events.count; ++i) {
      EXPECT_EQ(events[i].cloth.index, sheet.index);
      EXPECT_LT(events[i].vertex, n * n);
      EXPECT_EQ(events[i].time, test.world().time());
      EXPECT_NE(std::string(events[i].text).find("safety"), std::string::npos);
    }
  }
  EXPECT_EQ(stretches, 1);
  EXPECT_EQ(energies, 1);
}

/// Led apart and back, twice: told each time it goes beyond.
TEST_P(StartOverlap, ALargeStretchIsToldAgainOnceItWasBelow) {
  TestWorld test(world_with(GetParam(), weft::Form::summed, 0.9));
  const std::vector<weft::double3> x{{0, 0, 0}, {0.1, 0, 0}};
  const std::vector<weft::Spring> springs{{0, 1, 10, -1}};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.springs = springs;
  weft::ClothDesc desc;
  const std::vector<weft::Pin> pins{{0}, {1}};
  desc.pins = pins;
  const weft::ClothId cloth = test.add(network, desc);
  int found = 0;
  for (const double at : {1.0, 1.09, 1.2, 1.3, 0.5, 0.5, 2.0, 2.0}) {
    const uint32_t vertex = 1;
    const weft::double3 target{at, 0, 0};
    ASSERT_EQ(test.world().move_pins(cloth, weft::View<uint32_t>(&vertex, 1),
                                     weft::View<weft::double3>(&target, 1)),
              weft::Status::ok);
    test.step(dt);
    found += told(test, weft::EventType::large_stretch);
    EXPECT_EQ(found, at > 1.4 ? 2 : at > 1.1 ? 1 : found);
  }
  EXPECT_EQ(found, 2);
}

INSTANTIATE_TEST_SUITE_P(Precision, StartOverlap, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::start_overlap
