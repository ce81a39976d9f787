// A cloth that is created in a world which has stepped begins as in a fresh one: for every force
// that reads velocities or the step, in both forms, to the bit where the substep is the same.
#include "reference/effects.h"

#include <functional>

namespace weft_tests {
namespace {

using Setting = std::tuple<weft::Precision, weft::Form, weft::Start>;

class Newcomer : public testing::TestWithParam<Setting> {
 protected:
  weft::WorldDesc desc() const {
    weft::WorldDesc world;
    std::tie(world.precision, world.form, world.start) = GetParam();
    world.gravity = {1, -9, 2};
    world.substeps = 4;
    world.unsafe = true;  // what is compared need not be calm
    return world;
  }
};

constexpr double dt = 1.0 / 60;

struct Guest {
  const char* name;
  std::function<weft::ClothId(TestWorld&)> add;
  weft::Evaluation evaluation = weft::Evaluation::automatic;
  weft::Accumulate accumulate = weft::Accumulate::native;
};

const std::vector<weft::Pin>& two_pins() {
  static const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {8, weft::Pin::fixed}};
  return pins;
}

weft::GridDesc small_grid() {
  weft::GridDesc grid;
  grid.rows = grid.columns = 9;
  grid.material.stiffness = 1;
  grid.material.mass.value = 0.05;
  return grid;
}

weft::ClothDesc thrown() {
  weft::ClothDesc cloth;
  cloth.pins = two_pins();
  cloth.velocity = {2, 1, -3};
  return cloth;
}

weft::ClothId add_sheet(TestWorld& test, std::function<void(weft::ClothDesc&)> change) {
  weft::ClothDesc cloth = thrown();
  change(cloth);
  return test.add(small_grid(), cloth);
}

/// A wheel of 300 spokes, whose middle is a hub.
weft::ClothId add_wheel(TestWorld& test) {
  NetworkParts wheel;
  wheel.positions = {{0, 0, 0}};
  wheel.masses = {0.3};
  for (uint32_t i = 1; i <= 300; ++i) {
    wheel.positions.push_back(turned({1, 0, 0}, {0, 0, 1}, 1.2 * i));
    wheel.springs.push_back({0, i, 0.4, 1});
    wheel.velocities.push_back({0, 0, 0});
  }
  wheel.velocities.push_back({0, 0, 0});
  for (size_t i = 0; i < wheel.velocities.size(); ++i)
    wheel.velocities[i] = 0.5 * wheel.positions[i] + Vec{0, 0, 0.01 * double(i % 7)};
  weft::ClothDesc cloth;
  cloth.spring_damping = 0.02;
  return add_network(test, wheel, cloth);
}

std::vector<Guest> guests() {
  const auto damped = [](TestWorld& t) {
    return add_sheet(t, [](weft::ClothDesc& c) { c.spring_damping = 0.01; });
  };
  const auto on_mesh = [](TestWorld& t) {
    weft::ClothDesc cloth = thrown();
    cloth.spring_damping = 0.01;
    weft::Material material = small_grid().material;
    return add_mesh_cloth(t, reference::sheet(1, 8, 0.1), material, cloth);
  };
  const auto scatter = weft::Evaluation::scatter;
  return {
      {"plain", [](TestWorld& t) { return add_sheet(t, [](weft::ClothDesc&) {}); }},
      {"central", [](TestWorld& t) { return add_sheet(t, [](auto& c) { c.drag = 0.003; }); }},
      {"lagged",
       [](TestWorld& t) {
         return add_sheet(t, [](auto& c) {
           c.drag = 0.003;
           c.drag_model = weft::DragModel::lagged;
         });
       }},
      {"damped_grid", damped},
      {"damped_mesh", on_mesh},
      {"tethered",
       [](TestWorld& t) { return add_sheet(t, [](auto& c) { c.tether_scale = 1.01; }); }},
      {"hub", add_wheel},
      {"scattered", damped, scatter},
      {"scattered_hub", add_wheel, scatter},
      {"fixed64", damped, scatter, weft::Accumulate::fixed64},
  };
}

weft::WorldDesc with(weft::WorldDesc desc, const Guest& guest) {
  desc.evaluation = guest.evaluation;
  desc.accumulate = guest.accumulate;
  return desc;
}

void add_wind(TestWorld& test) { test.check(test.world().set_wind({{3, -1, 8}, 1.2, 1, 0.4})); }

TEST_P(Newcomer, MovesAsInAFreshWorldToTheBit) {
  for (const Guest& guest : guests())
    for (const bool windy : {false, true}) {
      TestWorld fresh(with(desc(), guest));
      if (windy) add_wind(fresh);
      const weft::ClothId first = guest.add(fresh);
      fresh.step(dt);
      const std::vector<Vec> after_one = fresh.positions(first);
      fresh.step(dt / 2);
      fresh.step(dt, 6);
      for (const double before : {dt / 10, dt, 0.35, 200.0}) {
        TestWorld old(with(desc(), guest));
        if (windy) add_wind(old);
        old.step(before, 3);
        const weft::ClothId second = guest.add(old);
        old.step(dt);
        const std::vector<Vec> x = old.positions(second);
        for (size_t i = 0; i < x.size(); ++i)
          ASSERT_TRUE(same_bits(x[i], after_one[i])) << guest.name << ' ' << windy << ' ' << before;
        old.step(dt / 2);
        old.step(dt, 6);
        EXPECT_EQ(old.hash(), fresh.hash()) << guest.name << ' ' << windy << ' ' << before;
      }
    }
}

TEST_P(Newcomer, LeavesTheOthersAsTheyAreWithoutIt) {
  for (const Guest& guest : guests()) {
    TestWorld alone(with(desc(), guest)), joined(with(desc(), guest));
    std::vector<weft::ClothId> ids;
    for (TestWorld* test : {&alone, &joined}) {
      add_wind(*test);
      ids.push_back(guest.add(*test));
      test->step(dt, 5);
    }
    const uint32_t count = uint32_t(alone.positions(ids[0]).size());
    guest.add(joined);
    for (const double step : {dt / 3, dt / 3, dt}) {  // the step changes as the newcomer comes
      alone.step(step);
      joined.step(step);
      const std::vector<Vec> x = alone.positions(ids[0], count);
      const std::vector<Vec> y = joined.positions(ids[1], count);
      for (size_t i = 0; i < x.size(); ++i)
        ASSERT_TRUE(same_bits(x[i], y[i])) << guest.name << ' ' << i;
    }
  }
}

TEST_P(Newcomer, StepsAsPreparedOrOtherwise) {
  const auto damped = guests()[4];
  for (const bool changes : {false, true}) {
    TestWorld fresh(desc());
    add_wind(fresh);
    const weft::ClothId first = damped.add(fresh);
    if (changes) {
      fresh.check(fresh.world().set_gravity({0, 5, 1}));
      fresh.check(fresh.world().set_wind({{-4, 1, 2}, 1, 0.9, 0.1}));
    }
    fresh.step(dt, 4);
    const std::vector<Vec> expected = fresh.positions(first);
    TestWorld old(desc());
    add_wind(old);
    old.step(0.2, 2);
    const weft::ClothId second = damped.add(old);
    old.check(old.world().prepare(0.3));
    old.velocities(second);
    if (changes) {
      old.check(old.world().set_gravity({0, 5, 1}));
      old.check(old.world().set_wind({{-4, 1, 2}, 1, 0.9, 0.1}));
    }
    old.check(old.world().prepare(dt / 7));
    old.step(dt, 4);
    const std::vector<Vec> x = old.positions(second);
    for (size_t i = 0; i < x.size(); ++i) ASSERT_TRUE(same_bits(x[i], expected[i])) << changes;
  }
}

TEST_P(Newcomer, IsReadAsInAFreshWorldBeforeItsFirstStep) {
  const auto sheet = guests()[1];
  TestWorld fresh(desc()), old(desc());
  add_wind(fresh);
  add_wind(old);
  old.step(0.35, 2);
  const weft::ClothId a = sheet.add(fresh), b = sheet.add(old);
  fresh.check(fresh.world().prepare(dt));
  old.check(old.world().prepare(dt));
  const std::vector<Vec> v = fresh.velocities(a), u = old.velocities(b);
  for (size_t i = 0; i < v.size(); ++i) expect_near(u[i], v[i], 1e-4);
}

std::string setting_name(const testing::TestParamInfo<Setting>& info) {
  const auto [precision, form, start] = info.param;
  return std::string(weft::to_string(precision)) +
         (form == weft::Form::position ? "_position" : "_summed") +
         (start == weft::Start::lagged ? "_lagged" : "_taylor");
}
INSTANTIATE_TEST_SUITE_P(
    Variants, Newcomer,
    testing::Combine(testing::Values(weft::Precision::float32, weft::Precision::float64),
                     testing::Values(weft::Form::summed, weft::Form::position),
                     testing::Values(weft::Start::taylor, weft::Start::lagged)),
    setting_name);

}  // namespace
}  // namespace weft_tests
