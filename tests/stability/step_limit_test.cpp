// Below the stable limit motion stays bounded, above it grows at the known rate.
#include "reference/closed_forms.h"
#include "reference/networks.h"
#include "reference/random.h"

#include <cmath>
#include <numbers>

namespace weft_tests {
namespace {

weft::WorldDesc unsafe_world(weft::Precision precision) {
  weft::WorldDesc desc = plain_world(precision);
  desc.unsafe = true;
  return desc;
}

using Limit = BothPrecisions;

TEST_P(Limit, AboveItASpringGrowsByTheKnownFactor) {
  struct Growth {
    double ratio, factor;
  };
  for (const Growth growth :
       {Growth{1.0001, 1.0286878268}, Growth{1.001, 1.0935565421}, Growth{1.01, 1.3265844270},
        Growth{1.05, 1.8773280449}, Growth{1.1, 2.4281666529}, Growth{1.5, 6.8541}}) {
    ASSERT_NEAR(reference::growth(2 * growth.ratio), growth.factor, 1e-4);
    // Without rest length: x_n = (-1)^n x_0 cosh(n ln factor).
    AnchoredMass mass;
    mass.rest_length = 0;
    mass.start = {1, 0, 0};
    TestWorld test(unsafe_world(GetParam()));
    const weft::ClothId cloth = mass.add_to(test);
    const double dt = 0.2 * growth.ratio,
                 rate = std::acosh(200 * growth.ratio * growth.ratio / 100 - 1);
    test.step(dt, 10);
    const double expected = std::cosh(10 * rate);
    EXPECT_NEAR(test.position(cloth, 1).x, expected,
                GetParam() == weft::Precision::float64 ? 1e-10 * expected : 2e-5 * expected)
        << growth.ratio;
  }
}

TEST_P(Limit, OnePercentAboveIsAMillionTimesIn49Steps) {
  AnchoredMass mass;
  mass.rest_length = 0;
  mass.start = {1, 0, 0};
  TestWorld test(unsafe_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  test.step(0.202, 49);
  EXPECT_NEAR(std::log10(-test.position(cloth, 1).x / 0.5), 6, 0.02);
}

TEST_P(Limit, JustBelowItASpringStaysBounded) {
  AnchoredMass mass;
  mass.rest_length = 0;
  mass.start = {1, 0, 0};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  for (int n = 0; n < 2000; ++n) {
    test.step(0.2 * 0.999);
    ASSERT_LE(std::abs(test.position(cloth, 1).x), 1.0001) << n;
  }
}

struct NoisyChain {
  int masses;
  reference::Ends ends;
  double dt_max;  // published
};

class ChainLimit : public testing::TestWithParam<NoisyChain> {
 protected:
  /// Largest displacement after `steps` from noise of 1e-6 m; infinite when the world diverged.
  double largest(double ratio, int steps) const {
    const NoisyChain chain = GetParam();
    reference::SplitMix random(3);
    NetworkParts parts;
    parts.masses = {0.01};
    const int left = chain.ends == reference::Ends::free_free ? 0 : 1;
    const int right = chain.ends == reference::Ends::fixed_fixed ? 1 : 0;
    const int count = chain.masses + left + right;
    for (int i = 0; i < count; ++i) {
      const bool pinned = (left && i == 0) || (right && i == count - 1);
      parts.positions.push_back({double(i), 0, 0});
      parts.start.push_back({i + (pinned ? 0 : 2e-6 * (random.uniform() - 0.5)), 0, 0});
      if (pinned) parts.pins.push_back(uint32_t(i));
      if (i > 0) parts.springs.push_back({uint32_t(i - 1), uint32_t(i), 100, 1});
    }
    TestWorld test(unsafe_world(weft::Precision::float64));
    const weft::ClothId cloth = add_network(test, parts);
    for (int n = 0; n < steps; ++n) {
      const weft::Status status = test.world().step(ratio * chain.dt_max);
      if (status == weft::Status::diverged) return HUGE_VAL;
      test.check(status);
    }
    double most = 0;
    const std::vector<Vec> x = test.positions(cloth);
    for (int i = 0; i < count; ++i) most = std::max(most, std::abs(x[size_t(i)].x - i));
    return most;
  }
};

TEST_P(ChainLimit, BelowItNoiseStaysNoise) { EXPECT_LE(largest(0.999, 20000), 1e-4); }
TEST_P(ChainLimit, AboveItNoiseGrowsWithoutBound) { EXPECT_GE(largest(1.001, 20000), 1); }

TEST_P(ChainLimit, IsTheClosedForm) {
  const auto [masses, ends, dt_max] = GetParam();
  const int last = ends == reference::Ends::free_free ? masses - 1 : masses;
  EXPECT_NEAR(0.01 / std::sin(reference::chain_phase(ends, masses, last)), dt_max, 1e-11);
}

std::string chain_name(const testing::TestParamInfo<NoisyChain>& info) {
  const char* names[] = {"free", "fixed_fixed", "fixed_free"};
  return names[int(info.param.ends)] + std::to_string(info.param.masses);
}
INSTANTIATE_TEST_SUITE_P(
    Chains, ChainLimit,
    testing::Values(NoisyChain{2, reference::Ends::free_free, 0.014142135624},
                    NoisyChain{8, reference::Ends::free_free, 0.010195911582},
                    NoisyChain{8, reference::Ends::fixed_fixed, 0.010154266119},
                    NoisyChain{8, reference::Ends::fixed_free, 0.010173218375},
                    NoisyChain{32, reference::Ends::free_free, 0.010012059965},
                    NoisyChain{32, reference::Ends::fixed_fixed, 0.010011339452},
                    NoisyChain{32, reference::Ends::fixed_free, 0.010011691385}),
    chain_name);

TEST(HubLimit, AutomaticStepKeepsAHubBounded) {
  const uint32_t spokes = 100000;
  NetworkParts hub;
  hub.positions = {{0, 0, 0}};
  hub.masses = {1};
  for (uint32_t i = 1; i <= spokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / spokes;
    hub.positions.push_back({std::cos(angle), std::sin(angle), 0});
    hub.springs.push_back({0, i, 1, 1});
  }
  hub.start = hub.positions;
  hub.start[0] = {1e-3, 0, 0};
  weft::WorldDesc desc = plain_world(weft::Precision::float32);
  desc.substeps = 0;
  TestWorld test(desc);
  const weft::ClothId cloth = add_network(test, hub);
  for (int frame = 0; frame < 100; ++frame) {
    test.step(1.0 / 60);
    ASSERT_LE(length(test.positions(cloth)[0]), 2e-3) << frame;
  }
  EXPECT_GE(test.world().stats().dt_least, 0.4 * 0.008944182469 * 0.9);
}

INSTANTIATE_TEST_SUITE_P(Precision, Limit, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
