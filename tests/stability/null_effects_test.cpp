// Effects that do nothing change no bit (HC73), and neither does leaving out far colliders.
#include "reference/effects.h"
#include "reference/random.h"
#include "reference/sheets.h"

#include <functional>

namespace weft_tests {
namespace {

class NullEffect : public testing::TestWithParam<std::tuple<weft::Precision, weft::Form>> {
 protected:
  weft::WorldDesc desc() const {
    weft::WorldDesc world;
    std::tie(world.precision, world.form) = GetParam();
    return world;
  }
};

/// A hanging sheet and a crumpled mesh that meet a sphere, each as `change` makes it.
using Change = std::function<void(weft::ClothDesc&)>;
void add_scene(TestWorld& test, const Change& change) {
  weft::ClothDesc hanging;
  const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {12, weft::Pin::fixed}};
  hanging.pins = pins;
  hanging.pose = {{1, 0, 0}, 80, {0, 1, 0}};
  change(hanging);
  weft::GridDesc grid;
  grid.rows = 11;
  grid.columns = 13;
  grid.material.mass.value = 0.3;
  test.add(grid, hanging);
  weft::ClothDesc falling;
  falling.pose.translate = {0.5, 1.5, 0};
  change(falling);
  weft::Material material;
  material.mass.value = 0.2;
  add_mesh_cloth(test, reference::sheet(0.6, 7, 0.1), material, falling);
  add_body(test, Body::sphere, {0.5, 0.9, -0.2}, 0.4, 0.3);
}

/// Two worlds that differ by what ought to be nothing, over 200 steps.
void expect_nothing(const weft::WorldDesc& desc, const Change& change,
                    const std::function<void(TestWorld&)>& add) {
  TestWorld bare(desc), with(desc);
  add_scene(bare, [](weft::ClothDesc&) {});
  add_scene(with, change);
  add(with);
  for (int n = 0; n < 200; ++n) {
    bare.step(1.0 / 60);
    with.step(1.0 / 60);
    ASSERT_EQ(bare.hash(), with.hash()) << n;
  }
}

constexpr auto unchanged = [](weft::ClothDesc&) {};
constexpr auto nothing = [](TestWorld&) {};

TEST_P(NullEffect, FarCollidersOfEveryShape) {
  for (const Body body : every_body) {
    SCOPED_TRACE(name(body));
    expect_nothing(desc(), unchanged, [&](TestWorld& test) {
      add_body(test, body, {900, -800, 700}, 1, 0.5);
    });
  }
  expect_nothing(desc(), unchanged, [](TestWorld& test) {
    for (int i = 0; i < 64; ++i) add_body(test, Body::sphere, {900.0 + i, -800, 700}, 1);
  });
}

TEST_P(NullEffect, WindWithoutAirOrHold) {
  expect_nothing(desc(), unchanged, [](TestWorld& test) {
    test.check(test.world().set_wind({{9, 5, 7}, 0, 1, 1}));
  });
  expect_nothing(desc(), unchanged, [](TestWorld& test) {
    test.check(test.world().set_wind({{9, 5, 7}, 1.225, 0, 0}));
  });
  expect_nothing(desc(), unchanged, [](TestWorld& test) {
    test.check(test.world().set_wind({{9, 5, 7}}));
    test.check(test.world().clear_wind());
  });
}

TEST_P(NullEffect, ZeroDragDampingAndForce) {
  const std::vector<weft::VertexForce> no_force{{3, {0, 0, 0}}};
  expect_nothing(
      desc(), [](weft::ClothDesc& c) { c.drag_model = weft::DragModel::lagged; }, nothing);
  expect_nothing(
      desc(), [](weft::ClothDesc& c) { c.drag = c.spring_damping = 0; }, nothing);
  expect_nothing(
      desc(), [&](weft::ClothDesc& c) { c.forces = no_force; }, nothing);
}

TEST_P(NullEffect, SleepThatNeverComes) {
  expect_nothing(
      desc(), [](weft::ClothDesc& c) { c.sleep_speed = 1e-12; }, nothing);
}

/// A sheet that falls over spheres, or whose particles fly apart, or that fast pins pull through.
enum class Motion { falls, explodes, pulled };
void add_busy_sheet(TestWorld& test, Motion motion) {
  Sheet sheet;
  sheet.rows = sheet.columns = 24;
  sheet.stiffness = motion == Motion::explodes ? 0.5 : 20;
  reference::SplitMix random(5);
  std::vector<weft::double3> velocities;
  for (uint32_t i = 0; i < sheet.count(); ++i)
    velocities.push_back(to_weft(random.noise(motion == Motion::explodes ? 40 : 0.1)));
  weft::PinMotion motions[1];
  motions[0].velocity = {0, -8, 0};
  motions[0].amplitude = {2, 0, 1};
  motions[0].omega = 16;
  const std::vector<weft::Pin> pins{{0, 0}, {23, 0}};
  weft::ClothDesc desc;
  const std::vector<weft::double3> start = to_weft(sheet.start());
  desc.positions = weft::View<weft::double3>(start);
  desc.velocities = velocities;
  desc.drag = 0.002;
  if (motion == Motion::pulled) {
    desc.pins = pins;
    desc.motions = weft::View<weft::PinMotion>(motions, 1);
  }
  test.add(sheet.grid(), desc);
}

std::vector<Vec> centres() {
  std::vector<Vec> at;
  for (int i = 0; i < 30; ++i)
    at.push_back({0.2 * (i % 6), -0.1 - 0.25 * (i / 6), 0.15 * (i / 6) - 0.3});
  return at;
}

/// Hashes after each of `frames` frames of 1/64 s, every one in 8 substeps or 8 steps of one.
std::vector<uint64_t> run(weft::WorldDesc desc, Motion motion, bool one_by_one, int far, int near,
                          bool bare = false) {
  desc.substeps = one_by_one ? 1 : 8;
  desc.unsafe = true;
  TestWorld test(desc);
  add_busy_sheet(test, motion);
  if (!bare)
    for (const Vec c : centres()) add_body(test, Body::sphere, c + Vec{0, 0.08, 0}, 0.08, 0.4);
  for (int i = 0; i < far; ++i) add_body(test, Body::sphere, {1e5 + i, 0, 0}, 0.1);
  // In the middles of the others, where no particle comes.
  for (int i = 0; i < near; ++i)
    add_body(test, Body::sphere, centres()[size_t(i) % 30] + Vec{0, 1e-6, 0}, 1e-6);
  std::vector<uint64_t> hashes;
  for (int n = 0; n < 60; ++n) {
    if (one_by_one) {
      test.step(1.0 / 512, 8);
    } else {
      test.step(1.0 / 64);
    }
    hashes.push_back(test.hash());
  }
  return hashes;
}

TEST_P(NullEffect, LeavingOutFarCollidersInAnyWay) {
  for (const Motion motion : {Motion::falls, Motion::explodes, Motion::pulled}) {
    SCOPED_TRACE(int(motion));
    const std::vector<uint64_t> expected = run(desc(), motion, false, 0, 0);
    EXPECT_NE(run(desc(), motion, false, 0, 0, true), expected) << "it meets no sphere";
    EXPECT_EQ(run(desc(), motion, false, 500, 0), expected) << "500 far ones";
    EXPECT_EQ(run(desc(), motion, false, 0, 60), expected) << "more near ones than a mask holds";
    EXPECT_EQ(run(desc(), motion, false, 300, 120), expected) << "both";
    EXPECT_EQ(run(desc(), motion, true, 0, 0), expected) << "lists made for every substep";
  }
}

std::string variant_name(const testing::TestParamInfo<NullEffect::ParamType>& info) {
  return std::string(weft::to_string(std::get<0>(info.param))) +
         (std::get<1>(info.param) == weft::Form::summed ? "_summed" : "_position");
}
INSTANTIATE_TEST_SUITE_P(Variants, NullEffect,
                         testing::Combine(both_precisions(), testing::Values(weft::Form::summed,
                                                                             weft::Form::position)),
                         variant_name);

}  // namespace
}  // namespace weft_tests
