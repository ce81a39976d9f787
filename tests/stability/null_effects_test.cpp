// Effects that do nothing change no bit (HC73), and neither does leaving out far colliders.
#include "reference/effects.h"
#include "reference/random.h"
#include "reference/sheets.h"
#include "samples/effects/effects.h"

namespace weft_tests {
namespace {

using weft::samples::Change;
using weft::samples::Changes;

class NullEffect : public testing::TestWithParam<std::tuple<weft::Precision, weft::Form>> {
 protected:
  weft::WorldDesc desc() const {
    weft::WorldDesc world;
    std::tie(world.precision, world.form) = GetParam();
    return world;
  }
};

/// A hanging sheet and a crumpled mesh that meet a sphere, with what `changes` make of them.
class Scene {
 public:
  Scene(const weft::WorldDesc& desc, const Changes& changes)
      : changes_(changes), test_(begun(desc, changes)) {
    hang_sheet();
    drop_mesh();
    weft::SphereDesc sphere{{0.5, 0.2, 0.5}, 0.4};
    sphere.friction = 0.3;
    test_.take(test_.world().create_sphere(sphere));
    weft::samples::furnish(changes_, stage_);
  }
  /// After each of 200 steps.
  std::vector<uint64_t> hashes() {
    std::vector<uint64_t> all;
    for (int frame = 1; frame <= 200; ++frame) {
      weft::samples::lead(changes_, stage_, frame);
      test_.step(1.0 / 60);
      all.push_back(test_.hash());
    }
    return all;
  }

 private:
  static weft::WorldDesc begun(weft::WorldDesc desc, const Changes& changes) {
    desc.gravity = weft::samples::down;
    weft::samples::begin(changes, desc);
    return desc;
  }
  void hang_sheet() {
    weft::ClothDesc hanging;
    const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {16, weft::Pin::fixed}};
    hanging.pins = pins;
    hanging.pose = {{1, 0, 0}, 10, {0, 0, 1}};
    weft::samples::dress(changes_, hanging);
    weft::GridDesc grid;
    grid.rows = 16;
    grid.columns = 17;
    grid.material.mass.value = 0.3;
    stage_.cloths.push_back(test_.add(grid, hanging));
  }
  void drop_mesh() {
    weft::ClothDesc falling;
    falling.pose = {{1, 0, 0}, 90, {0.5, 0.1, 1.5}};
    weft::samples::dress(changes_, falling);
    weft::Material material;
    material.mass.value = 0.2;
    stage_.cloths.push_back(
        add_mesh_cloth(test_, reference::sheet(0.6, 15, 0.1), material, falling));
  }

  Changes changes_;
  TestWorld test_;
  weft::samples::Stage stage_{test_.context(), test_.world(), {}, {}};
};

std::vector<uint64_t> hashes(const weft::WorldDesc& desc, const Changes& changes) {
  return Scene(desc, changes).hashes();
}

TEST_P(NullEffect, ChangesNoBit) {
  for (const weft::samples::Effect& effect : weft::samples::effects) {
    if (!effect.null[0]) continue;
    const std::vector<uint64_t> bare = hashes(desc(), {&effect.needs});
    for (const Change& change : effect.null) {
      if (!change) continue;
      EXPECT_EQ(hashes(desc(), {&effect.needs, &change}), bare)
          << effect.name << ", null[" << &change - effect.null << "]";
    }
  }
}

TEST_P(NullEffect, SleepThatNeverComes) {
  const Change sleep{.dress = [](weft::ClothDesc& c) { c.sleep_speed = 1e-12; }};
  EXPECT_EQ(hashes(desc(), {&sleep}), hashes(desc(), {}));
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
    // Until the cloth is so far away that its origin follows, which it does between frames.
    const std::vector<uint64_t> often = run(desc(), motion, true, 0, 0);
    for (size_t n = 0; n < 16; ++n) EXPECT_EQ(often[n], expected[n]) << "a list for every substep";
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
