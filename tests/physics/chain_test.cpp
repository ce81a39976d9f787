// Longitudinal modes of a chain: displacement = A cos(2n asin(w_j dt/2)) mode_j, exactly.
#include "reference/closed_forms.h"
#include "reference/networks.h"

#include <numbers>

namespace weft_tests {
namespace {

using reference::Ends;

constexpr double k = 100, m = 0.01;

struct Chain {
  Ends ends;
  int masses;
};

/// Masses at spacing h on the x axis, displaced by `displacement(i)`; ends pinned as asked.
template <class Displacement>
weft::ClothId add_chain(TestWorld& test, Chain chain, double h, Displacement displacement) {
  NetworkParts parts;
  parts.masses = {m};
  const int before = chain.ends == Ends::free_free ? 0 : 1;
  const int after = chain.ends == Ends::fixed_fixed ? 1 : 0;
  for (int i = -before; i < chain.masses + after; ++i) {
    const bool pinned = i < 0 || i == chain.masses;
    const uint32_t id = uint32_t(i + before);
    parts.positions.push_back({(i + before) * h, 0, 0});
    parts.start.push_back({(i + before) * h + (pinned ? 0 : displacement(i)), 0, 0});
    if (pinned) parts.pins.push_back(id);
    if (id > 0) parts.springs.push_back({id - 1, id, k, h});
  }
  return add_network(test, parts);
}

class ChainModes : public testing::TestWithParam<std::tuple<Chain, weft::Precision>> {
 protected:
  const Chain chain = std::get<0>(GetParam());
  const weft::Precision precision = std::get<1>(GetParam());
  const int first = chain.ends == Ends::free_free ? 0 : 1;
  const uint32_t offset = chain.ends == Ends::free_free ? 0 : 1;
};

TEST_P(ChainModes, EveryModeMovesAlone) {
  const double amplitude = 1e-3, h = 0.01, dt = 0.009;
  const int last = first + chain.masses - 1;
  for (int j = first; j <= last; j += (chain.masses > 8 ? 5 : 1)) {
    const double w =
        2 * std::sqrt(k / m) * std::sin(reference::chain_phase(chain.ends, chain.masses, j));
    TestWorld test(plain_world(precision));
    const weft::ClothId cloth = add_chain(test, chain, h, [&](int i) {
      return amplitude * reference::chain_mode(chain.ends, chain.masses, j, i);
    });
    for (int n : {1, 10, 100, 1000}) {
      test.step(dt, n - int(test.world().stats().steps));
      const double turn = std::cos(2 * n * std::asin(w * dt / 2));
      const std::vector<Vec> x = test.positions(cloth);
      for (int i = 0; i < chain.masses; ++i) {
        const double rest = (i + double(offset)) * h;
        const double u = amplitude * reference::chain_mode(chain.ends, chain.masses, j, i) * turn;
        ASSERT_NEAR(x[uint32_t(i) + offset].x, rest + u, tolerance(precision, chain.masses * h))
            << "mode " << j << ", mass " << i << ", step " << n;
      }
    }
  }
}

std::string chain_name(const testing::TestParamInfo<ChainModes::ParamType>& info) {
  const auto& [chain, precision] = info.param;
  const char* ends = chain.ends == Ends::free_free     ? "free"
                     : chain.ends == Ends::fixed_fixed ? "fixed_fixed"
                                                       : "fixed_free";
  return std::string(ends) + std::to_string(chain.masses) + "_" + weft::to_string(precision);
}
INSTANTIATE_TEST_SUITE_P(
    Chains, ChainModes,
    testing::Combine(testing::Values(Chain{Ends::free_free, 8}, Chain{Ends::fixed_fixed, 8},
                                     Chain{Ends::fixed_free, 8}, Chain{Ends::free_free, 32},
                                     Chain{Ends::fixed_fixed, 32}),
                     both_precisions()),
    chain_name);

TEST(ChainFrequencies, AgreeWithTheTable) {
  const double w0 = std::sqrt(k / m);
  const double fixed[8] = {34.729635533,  68.404028665,  100,           128.557521937,
                           153.208888624, 173.205080757, 187.938524157, 196.961550602};
  const double free[8] = {0,
                          39.018064403,
                          76.536686473,
                          111.114046604,
                          141.421356237,
                          166.293922461,
                          184.775906502,
                          196.157056081};
  for (int j = 0; j < 8; ++j) {
    EXPECT_NEAR(2 * w0 * std::sin(reference::chain_phase(Ends::free_free, 8, j)), free[j], 1e-9);
    EXPECT_NEAR(2 * w0 * std::sin(reference::chain_phase(Ends::fixed_fixed, 8, j + 1)), fixed[j],
                1e-9);
  }
}

TEST(ChainFrequencies, SecondMassAgreesWithThePublishedDisplacements) {
  const double dt = 0.9 * std::sqrt(m / k) / std::cos(std::numbers::pi / 18);
  struct Mode {
    int j;
    double u;
  };
  for (const Mode mode :
       {Mode{1, -8.688401476654e-5}, Mode{4, 2.205474800059e-4}, Mode{8, 5.878276973817e-4}}) {
    TestWorld test(plain_world(weft::Precision::float64));
    const weft::ClothId cloth = add_chain(test, {Ends::fixed_fixed, 8}, 1, [&](int i) {
      return 1e-3 * reference::chain_mode(Ends::fixed_fixed, 8, mode.j, i);
    });
    test.step(dt, 1000);
    EXPECT_NEAR(test.position(cloth, 2).x - 2, mode.u, 1e-10) << mode.j;
  }
}

TEST(ChainFrequencies, TransverseModeOfAStretchedChainIsSofter) {
  // k -> k (1 - 1/s) at stretch s, linear for a small amplitude: error of order A^3.
  const int masses = 8, j = 2;
  const double s = 2, h = 0.5, amplitude = 1e-6, dt = 0.005;
  NetworkParts parts;
  parts.masses = {m};
  for (int i = 0; i < masses + 2; ++i) {
    const uint32_t id = uint32_t(i);
    const bool pinned = i == 0 || i == masses + 1;
    parts.positions.push_back({i * s * h, 0, 0});
    parts.start.push_back(
        {i * s * h,
         pinned ? 0 : amplitude * reference::chain_mode(Ends::fixed_fixed, masses, j, i - 1), 0});
    if (pinned) parts.pins.push_back(id);
    if (i > 0) parts.springs.push_back({id - 1, id, k, h});
  }
  TestWorld test(plain_world(weft::Precision::float64));
  const weft::ClothId cloth = add_network(test, parts);
  test.step(dt, 200);
  const double w = 2 * std::sqrt(k * (1 - 1 / s) / m) *
                   std::sin(reference::chain_phase(Ends::fixed_fixed, masses, j));
  for (int i = 0; i < masses; ++i)
    EXPECT_NEAR(test.position(cloth, uint32_t(i) + 1).y,
                amplitude * reference::chain_mode(Ends::fixed_fixed, masses, j, i) *
                    std::cos(400 * std::asin(w * dt / 2)),
                1e-12);
}

}  // namespace
}  // namespace weft_tests
