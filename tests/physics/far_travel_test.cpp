// Cloths that travel: their origin follows, so that 100 km away they are as calm as where they were
// made.
#include <algorithm>
#include <cmath>

#include "reference/world_helpers.h"

namespace weft_tests::far_travel {
namespace {

struct Variant {
  weft::Precision precision;
  weft::Form form;
};
class FarTravel : public testing::TestWithParam<Variant> {
 protected:
  weft::WorldDesc world() const {
    weft::WorldDesc desc;
    desc.precision = GetParam().precision;
    desc.form = GetParam().form;
    return desc;
  }
};

weft::GridDesc flag() {
  weft::GridDesc grid;
  grid.rows = grid.columns = 12;
  grid.material.stiffness = weft::Stiffness(400, 100, 5);
  return grid;
}

/// Fastest of a cape against the bar that it hangs from, which travels along `way` at `speed`.
double unrest(const weft::WorldDesc& desc, weft::double3 way, double speed, double seconds) {
  TestWorld test(desc);
  weft::ClothDesc made;
  std::vector<weft::Pin> pins;
  std::vector<uint32_t> top;
  for (uint32_t c = 132; c < 144; ++c) {
    pins.push_back({c});
    top.push_back(c);
  }
  made.pins = pins;
  made.spring_damping = 0.3;
  made.drag = 0;
  made.velocity = {speed * way.x, speed * way.y, speed * way.z};
  const weft::ClothId cloth = test.add(flag(), made);
  std::vector<weft::double3> base, to(12);
  for (const uint32_t v : top) base.push_back(to_weft(test.position(cloth, v)));
  double fastest = 0;
  const int frames = int(60 * seconds);
  for (int n = 1; n <= frames; ++n) {
    const double gone = speed * n / 60;
    for (size_t i = 0; i < to.size(); ++i) {
      to[i] = {base[i].x + gone * way.x, base[i].y + gone * way.y, base[i].z + gone * way.z};
    }
    test.check(test.world().move_pins(cloth, top, weft::View<weft::double3>(to)));
    test.step(1.0 / 60);
    if (n < frames - 60) continue;
    for (const Vec& v : test.velocities(cloth)) {
      const double x = v.x - made.velocity.x, y = v.y - made.velocity.y, z = v.z - made.velocity.z;
      fastest = std::max(fastest, std::sqrt(x * x + y * y + z * z));
    }
  }
  return fastest;
}

TEST_P(FarTravel, ACarriedCapeHangsAsOneThatStands) {
  const double standing = unrest(world(), {1, 0, 0}, 0, 20);
  const bool summed = GetParam().form == weft::Form::summed;
  // 20 km at 500 m/s. In float32 a displacement of a metre is rounded by 6e-8 m a substep.
  const double rounding = GetParam().precision == weft::Precision::float64 ? 3e-3
                          : summed                                         ? 0.005
                                                                           : 0.05;
  for (const weft::double3 way : {weft::double3{1, 0, 0}, {0, -1, 0}, {0.6, 0, 0.8}}) {
    EXPECT_LE(unrest(world(), way, 500, 40), standing + rounding);
  }
}

/// Steps and speeds in powers of two: no addition rounds, and the whole way is exact if every shift
/// of the origin is.
TEST_P(FarTravel, TheOriginFollowsWithoutALostBit) {
  weft::WorldDesc desc = world();
  desc.gravity = {0, 0, 0};
  desc.substeps = 1;
  for (const weft::double3 velocity : {weft::double3{64, -32, 128}, {-1024, 8, 0}}) {
    TestWorld test(desc);
    std::vector<weft::double3> at;
    for (int v = 0; v < 100; ++v) at.push_back({v / 128.0, (v * 7 % 100) / 128.0, v % 9 / 8.0});
    weft::NetworkDesc loose;  // no springs: their roots would round
    loose.positions = weft::View<weft::double3>(at);
    weft::ClothDesc made;
    made.velocity = velocity;
    const weft::ClothId cloth = test.add(loose, made);
    const std::vector<Vec> start = test.positions(cloth);
    const int frames = 6400;  // 100 s
    test.step(1.0 / 64, frames);
    const double t = frames / 64.0;
    const std::vector<Vec> end = test.positions(cloth);
    for (size_t v = 0; v < end.size(); ++v) {
      ASSERT_EQ(end[v].x, start[v].x + velocity.x * t) << v;
      ASSERT_EQ(end[v].y, start[v].y + velocity.y * t) << v;
      ASSERT_EQ(end[v].z, start[v].z + velocity.z * t) << v;
    }
  }
}

TEST_P(FarTravel, OutputsInBetweenGoAlong) {
  weft::WorldDesc desc = world();
  desc.gravity = {0, 0, 0};
  desc.interpolate = true;
  TestWorld test(desc);
  weft::ClothDesc made;
  made.velocity = {50, 0, 0};
  const weft::ClothId cloth = test.add(flag(), made);
  const double x0 = test.position(cloth, 0).x;
  std::vector<weft::float3> drawn(144);
  weft::OutputDesc out;
  out.layout.position = {weft::Format::f32x3, 0, sizeof(weft::float3)};
  out.memory = drawn.data();
  test.take(test.world().bind_output(cloth, out));
  for (int n = 0; n < 600; ++n) {
    test.step(1.0 / 60);
    test.check(test.world().write_outputs(0.5));
    // The position form in float32 does not keep a speed to the last digit: a walk by rounding.
    ASSERT_NEAR(double(drawn[0].x), x0 + 50 * (test.world().time() - 0.5 / 60), 2e-3) << n;
    const weft::Bounds bounds = test.take(test.world().bounds(cloth));
    ASSERT_LE(bounds.low.x, double(drawn[0].x) + 1e-4);
    ASSERT_GE(bounds.high.x, double(drawn[0].x) - 1e-4);
  }
}

/// What sleeps far from where it was made stays where it is, and collides there.
TEST_P(FarTravel, ALandedClothRestsOnTheGroundThere) {
  weft::WorldDesc desc = world();
  TestWorld test(desc);
  weft::PlaneDesc ground;
  ground.friction = 0.8;
  ground.offset = -800;
  test.take(test.world().create_plane(ground));
  weft::ClothDesc made;
  made.pose.degrees = -90;
  made.velocity = {20, -60, 0};
  made.spring_damping = 0.1;
  made.sleep_speed = 0.05;
  made.sleep_time = 0.3;
  const weft::ClothId cloth = test.add(flag(), made);
  for (int n = 0; n < 1800 && !test.take(test.world().asleep(cloth)); ++n) test.step(1.0 / 60);
  ASSERT_TRUE(test.take(test.world().asleep(cloth)));
  const std::vector<Vec> before = test.positions(cloth);
  for (const Vec& x : before) EXPECT_NEAR(x.y, -800, 1e-3);
  test.step(1.0 / 60, 10);
  const std::vector<Vec> after = test.positions(cloth);
  for (size_t v = 0; v < after.size(); ++v) {
    ASSERT_EQ(after[v].x, before[v].x);
    ASSERT_EQ(after[v].y, before[v].y);
  }
}

/// A pendulum of springs, and perhaps a stray.
std::vector<Vec> swing(const weft::WorldDesc& desc, bool stray, weft::double3 stray_velocity) {
  TestWorld test(desc);
  std::vector<weft::double3> at = {{0, 0, 0}, {0.11, 0.05, 0}, {0.22, 0.13, 0.02}, {0.3, 0.2, 0}};
  std::vector<weft::Spring> springs = {{0, 1, 200, -1}, {1, 2, 200, -1}, {2, 3, 200, -1}};
  std::vector<weft::double3> velocity(4);
  if (stray) {
    const bool goes = stray_velocity.x != 0;
    at.push_back({goes ? 1 : 1e4, 0, 0});
    velocity.push_back(stray_velocity);
  }
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(at);
  network.springs = springs;
  network.material.mass.kind = weft::Mass::Kind::per_vertex;
  const std::vector<double> masses(at.size(), 0.1);
  network.material.mass.values = masses;
  weft::ClothDesc made;
  static const weft::Pin pins[] = {{0}};
  made.pins = {pins, 1};
  made.velocities = velocity;
  const weft::ClothId cloth = test.add(network, made);
  test.step(1.0 / 60, 120);
  std::vector<Vec> end = test.positions(cloth);
  end.resize(4);
  return end;
}

TEST_P(FarTravel, AStrayTakesNoPrecisionFromTheOthers) {
  const std::vector<Vec> alone = swing(world(), false, {0, 0, 0});
  for (const weft::double3 velocity : {weft::double3{0, 0, 0}, {5000, 0, 0}}) {
    const std::vector<Vec> with = swing(world(), true, velocity);
    for (size_t v = 0; v < alone.size(); ++v) {
      EXPECT_EQ(with[v].x, alone[v].x) << v;
      EXPECT_EQ(with[v].y, alone[v].y) << v;
      EXPECT_EQ(with[v].z, alone[v].z) << v;
    }
  }
}

std::string name_of(const testing::TestParamInfo<Variant>& info) {
  return std::string(to_string(info.param.precision)) +
         (info.param.form == weft::Form::summed ? "_summed" : "_position");
}
INSTANTIATE_TEST_SUITE_P(Variants, FarTravel,
                         testing::Values(Variant{weft::Precision::float32, weft::Form::summed},
                                         Variant{weft::Precision::float32, weft::Form::position},
                                         Variant{weft::Precision::float64, weft::Form::summed},
                                         Variant{weft::Precision::float64, weft::Form::position}),
                         name_of);

}  // namespace
}  // namespace weft_tests::far_travel
