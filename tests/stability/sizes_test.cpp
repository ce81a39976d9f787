// Sizes around those of blocks, cache lines and threads: no vertex is left out or done twice
// (HC80).
#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

class Sizes : public testing::TestWithParam<std::tuple<weft::Precision, uint32_t>> {
 protected:
  const weft::Precision precision = std::get<0>(GetParam());
  const uint32_t threads = std::get<1>(GetParam());

  weft::ContextDesc context() const {
    weft::ContextDesc desc = TestWorld::one_thread();
    desc.threads = threads;
    return desc;
  }
  void expect_fall(const std::vector<Vec>& x, double drop) const {
    for (size_t i = 0; i < x.size(); ++i)
      ASSERT_TRUE(same_bits(x[i].z, x[0].z)) << i << " of " << x.size();
    ASSERT_NEAR(x[0].z, -drop, tolerance(precision, drop));
  }
};

TEST_P(Sizes, EveryVertexOfAGridFallsAlike) {
  weft::WorldDesc desc = plain_world(precision);
  desc.gravity = {0, 0, -9.81};
  for (uint32_t rows : {1u, 2u, 31u, 33u, 256u})
    for (uint32_t columns : {1u, 31u, 32u, 33u, 63u, 65u, 255u, 256u, 257u}) {
      weft::GridDesc grid;
      grid.rows = rows;
      grid.columns = columns;
      grid.width = columns;
      grid.height = rows;
      grid.material.mass.value = double(rows) * columns;
      TestWorld test(desc, context());
      const weft::ClothId cloth = test.add(grid, weft::ClothDesc{});
      test.step(0.01, 5);
      SCOPED_TRACE(std::to_string(rows) + " x " + std::to_string(columns));
      expect_fall(test.positions(cloth), 9.81 * 0.05 * 0.05 / 2);
    }
}

TEST_P(Sizes, EveryParticleOfANetworkFallsAlike) {
  weft::WorldDesc desc = plain_world(precision);
  desc.gravity = {0, 0, -9.81};
  for (uint32_t count : {1u, 2u, 7u, 31u, 32u, 33u, 255u, 256u, 257u, 1023u, 1024u, 1025u, 4097u}) {
    NetworkParts parts;
    parts.masses = {1};
    for (uint32_t i = 0; i < count; ++i) {
      parts.positions.push_back({double(i), 0, 0});
      if (i > 0 && i % 3) parts.springs.push_back({i - 1, i, 100, -1});
    }
    TestWorld test(desc, context());
    const weft::ClothId cloth = add_network(test, parts);
    test.step(0.01, 5);
    expect_fall(test.positions(cloth), 9.81 * 0.05 * 0.05 / 2);
  }
}

TEST_P(Sizes, EverySizeFollowsTheReference) {
  const double dt = 5e-4;
  weft::WorldDesc desc = plain_world(precision);
  desc.gravity = {0, -9.81, 0};
  for (uint32_t rows : {2u, 5u, 31u})
    for (uint32_t columns : {3u, 16u, 33u, 65u}) {
      Sheet sheet;
      sheet.rows = rows;
      sheet.columns = columns;
      sheet.noise = 0.1 / std::max(rows, columns);
      sheet.pins = {0, columns - 1};
      reference::System system = sheet.system();
      system.gravity = {0, -9.81, 0};
      reference::Verlet verlet(system, dt);
      verlet.steps(50);
      for (bool network : {false, true}) {
        TestWorld test(desc, context());
        const weft::ClothId cloth = network ? sheet.add_network_to(test) : sheet.add_to(test);
        test.step(dt, 50);
        const std::vector<Vec> x = test.positions(cloth);
        for (size_t i = 0; i < x.size(); ++i)
          expect_near(x[i], verlet.positions()[i], tolerance(precision, 1));
        if (HasFailure()) FAIL() << rows << " x " << columns << (network ? " network" : " grid");
      }
    }
}

TEST_P(Sizes, ShuffledNetworkFollowsTheReference) {
  // Vertices and springs in random order, each spring in a random direction.
  const double dt = 5e-4;
  Sheet sheet;
  sheet.rows = 23;
  sheet.columns = 29;
  sheet.noise = 0.1 / 28;
  const reference::System system = sheet.system();
  reference::SplitMix random(17);
  const uint32_t count = sheet.count();
  std::vector<uint32_t> place(count);
  for (uint32_t i = 0; i < count; ++i) place[i] = i;
  for (uint32_t i = count; i > 1; --i)
    std::swap(place[i - 1], place[uint32_t(random.uniform() * i)]);
  NetworkParts parts;
  parts.masses = {sheet.vertex_mass};
  parts.positions.resize(count);
  for (uint32_t i = 0; i < count; ++i) parts.positions[place[i]] = system.positions[i];
  for (reference::Spring s : system.springs) {
    if (random.uniform() < 0.5) std::swap(s.a, s.b);
    parts.springs.push_back({place[s.a], place[s.b], s.stiffness, s.rest});
  }
  for (size_t i = parts.springs.size(); i > 1; --i)
    std::swap(parts.springs[i - 1], parts.springs[size_t(random.uniform() * double(i))]);
  reference::Verlet verlet(system, dt);
  verlet.steps(100);
  TestWorld test(plain_world(precision), context());
  const weft::ClothId cloth = add_network(test, parts);
  test.step(dt, 100);
  const std::vector<Vec> x = test.positions(cloth);
  for (uint32_t i = 0; i < count; ++i)
    expect_near(x[place[i]], verlet.positions()[i], tolerance(precision, 1));
}

std::string size_name(const testing::TestParamInfo<Sizes::ParamType>& info) {
  return std::string(weft::to_string(std::get<0>(info.param))) + "_threads" +
         std::to_string(std::get<1>(info.param));
}
INSTANTIATE_TEST_SUITE_P(Threads, Sizes,
                         testing::Combine(both_precisions(), testing::Values(1u, 2u, 3u)),
                         size_name);

}  // namespace
}  // namespace weft_tests
