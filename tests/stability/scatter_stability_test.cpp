// What scatter refuses, contains and survives: ranges, hubs, valence 0, pieces, equal springs
// (HC11 to HC13, HC19).
#include "reference/networks.h"
#include "reference/refusals.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

weft::WorldDesc scattering(weft::Accumulate accumulate,
                           weft::Precision precision = weft::Precision::float32) {
  weft::WorldDesc desc = plain_world(precision);
  desc.evaluation = weft::Evaluation::scatter;
  desc.accumulate = accumulate;
  return desc;
}

TEST(ScatterRefusal, AtomicNeedsThatDeterminismIsGivenUp) {
  TestWorld test;
  weft::WorldDesc desc = scattering(weft::Accumulate::atomic);
  expect_refusal(test, test.context().create_world(desc).status(),
                 {"atomic", "deterministic", "fixed64"});
  desc.deterministic = false;
  EXPECT_TRUE(bool(test.context().create_world(desc)));
}

TEST(ScatterRefusal, OtherSumsNeedAScatter) {
  TestWorld test;
  weft::WorldDesc desc;
  for (weft::Evaluation e : {weft::Evaluation::gather, weft::Evaluation::automatic}) {
    desc.evaluation = e;
    desc.accumulate = weft::Accumulate::fixed64;
    expect_refusal(test, test.context().create_world(desc).status(), {"fixed64", "scatter"});
  }
}

TEST(ScatterRefusal, ValuesOutOfRangeAreNamed) {
  TestWorld test;
  weft::WorldDesc desc;
  desc.evaluation = weft::Evaluation(3);
  expect_refusal(test, test.context().create_world(desc).status(), {"evaluation", "3"});
  desc.evaluation = weft::Evaluation::scatter;
  desc.accumulate = weft::Accumulate(7);
  expect_refusal(test, test.context().create_world(desc).status(), {"accumulate", "7"});
  desc.accumulate = weft::Accumulate::fixed8;
  for (double range : {0.0, -1.0, infinity, not_a_number}) {
    desc.fixed8_range = range;
    expect_refusal(test, test.context().create_world(desc).status(), {"fixed8_range"});
  }
}

/// Two masses that fly apart until the spring pulls more than the integers hold.
NetworkParts flying_apart(double speed) {
  NetworkParts parts;
  parts.positions = {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {6, 0, 0}};
  parts.springs = {{0, 1, 1, 1}, {2, 3, 1, 1}};
  parts.masses = {1};
  parts.velocities = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {speed, 0, 0}};
  return parts;
}

TEST(Fixed64Range, IsContainedAsAnErrorThatNamesVertexForceAndRange) {
  for (weft::Precision precision : {weft::Precision::float32, weft::Precision::float64}) {
    TestWorld test(scattering(weft::Accumulate::fixed64, precision));
    const weft::ClothId cloth = add_network(test, flying_apart(1e6));
    test.step(1e-3);  // 1000 m: within
    weft::Status status = weft::Status::ok;
    int steps = 1;
    for (; steps < 100 && status == weft::Status::ok; ++steps) {
      test.clear_log();
      status = test.world().step(1e-3);
    }
    EXPECT_EQ(status, weft::Status::diverged);
    EXPECT_GT(steps, 3);
    EXPECT_LE(steps, 7);  // the range is 4096 N
    for (const char* word : {"vertex 2", "vertex 3", "4096 N", "fixed64", "native"}) {
      EXPECT_NE(test.log().find(word), std::string::npos) << word << " in " << test.log();
    }
    const weft::View<weft::Event> events = test.world().events();
    ASSERT_EQ(events.count, 1u);
    EXPECT_EQ(events[0].type, weft::EventType::force_overflow);
    EXPECT_EQ(events[0].cloth, cloth);
    EXPECT_EQ(events[0].vertex, 2u);
    // Nothing wrapped: all stands where it was when it happened.
    EXPECT_TRUE(all_finite(test.positions(cloth, 4)));
    EXPECT_LE(length(test.positions(cloth, 4)[3]), 8000);
    EXPECT_EQ(test.world().step(1e-3), weft::Status::diverged);
  }
}

TEST(Fixed64Range, HoldsFourThousandTimesTheForceAtTwiceTheLength) {
  TestWorld test(scattering(weft::Accumulate::fixed64, weft::Precision::float64));
  const weft::ClothId cloth = add_network(test, flying_apart(1e6));
  test.step(1e-3, 4);
  EXPECT_NEAR(test.positions(cloth, 4)[3].x, 6 + 4e3, 1);
}

TEST(Fixed64Range, ReadingBeyondItIsRefusedAndChangesNothing) {
  TestWorld test(scattering(weft::Accumulate::fixed64));
  const weft::ClothId cloth = add_network(test, flying_apart(1e6));
  test.step(1e-3, 5);  // the last forces were within, those of the present are not
  std::vector<weft::double3> out(4);
  expect_refused_unchanged(
      test, {"vertex 2", "4096 N", "native"},
      [&] { return test.world().read_accelerations(cloth, out.data()); }, weft::Status::diverged);
  expect_refused_unchanged(
      test, {"vertex 2"}, [&] { return test.world().read_velocities(cloth, out.data()); },
      weft::Status::diverged);
  EXPECT_EQ(test.world().step(1e-3), weft::Status::diverged);
}

TEST(Fixed64Range, AHubDoesNotWrapIt) {
  NetworkParts hub;
  hub.positions = {{0, 0, 0}};
  hub.masses = {1};
  for (uint32_t i = 1; i <= 100000; ++i) {
    hub.positions.push_back({1, 0, 0});
    hub.springs.push_back({0, i, 1, 0});  // all pull the same way
  }
  TestWorld test(scattering(weft::Accumulate::fixed64, weft::Precision::float64));
  EXPECT_NEAR(test.accelerations(add_network(test, hub))[0].x, 1e5, 1e-5);
}

TEST(Fixed64Range, IsWatchedAlongEveryAxisInBothDirections) {
  for (const Vec way : {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}})
    for (const double side : {-1.0, 1.0})
      for (const bool second : {false, true}) {
        NetworkParts parts;
        parts.positions = {{0, 0, 0}, {1, 1, 1}};
        parts.springs = {{0, 1, 1, 1}};
        parts.masses = {1};
        parts.velocities = {{0, 0, 0}, {0, 0, 0}};
        parts.velocities[second ? 1 : 0] = (side * 1e6) * way;
        TestWorld test(scattering(weft::Accumulate::fixed64));
        const weft::ClothId cloth = add_network(test, parts);
        weft::Status status = weft::Status::ok;
        for (int n = 0; n < 12 && status == weft::Status::ok; ++n) {
          status = test.world().step(1e-3);
        }
        EXPECT_EQ(status, weft::Status::diverged) << way.x << way.y << way.z << side;
        EXPECT_LE(length(test.positions(cloth)[1] - test.positions(cloth)[0]), 1e4);
      }
}

TEST(Fixed64Range, TellsTheVertexInTheCallersOrderAndTheTimeOfTheSubstep) {
  // A chain of 100 vertices in an order of its own; at its end spring 57-12 is torn apart.
  NetworkParts parts;
  std::vector<uint32_t> chain;
  for (uint32_t i = 0; i < 100; ++i) {
    const uint32_t v = (i * 37) % 100;
    if (v != 57 && v != 12) chain.push_back(v);
  }
  parts.positions.resize(100);
  parts.velocities.resize(100);
  parts.masses = {1};
  for (size_t k = 0; k < chain.size(); ++k) {
    parts.positions[chain[k]] = {double((k * 41) % 97), 0, 0};
    if (k > 0) parts.springs.push_back({chain[k - 1], chain[k], 1e-6, 1});
  }
  parts.positions[57] = {200, 0, 0};
  parts.positions[12] = {200, 0, 1};
  parts.velocities[12] = {0, 0, 1e6};
  parts.springs.push_back({57, 12, 1, 1});
  weft::WorldDesc desc = scattering(weft::Accumulate::fixed64, weft::Precision::float64);
  desc.substeps = 4;
  TestWorld test(desc);
  const weft::ClothId cloth = add_network(test, parts);
  test.step(2e-3, 2);  // 4000 m: within 4096 N
  EXPECT_EQ(test.world().step(2e-3), weft::Status::diverged);
  const weft::View<weft::Event> events = test.world().events();
  ASSERT_EQ(events.count, 1u);
  EXPECT_EQ(events[0].cloth, cloth);
  EXPECT_TRUE(events[0].vertex == 57 || events[0].vertex == 12) << events[0].vertex;
  EXPECT_NE(test.log().find("vertex 57"), std::string::npos) << test.log();
  EXPECT_NE(test.log().find("vertex 12"), std::string::npos) << test.log();
  EXPECT_NEAR(events[0].time, 4.5e-3, 1e-12);  // 4500 m apart: the second substep of the third step
}

class AllSums : public testing::TestWithParam<weft::Accumulate> {
 protected:
  weft::WorldDesc desc() const {
    weft::WorldDesc d = scattering(GetParam());
    d.deterministic = GetParam() != weft::Accumulate::atomic;
    return d;
  }
};

TEST_P(AllSums, VertexWithoutSpringsFallsFreely) {
  weft::WorldDesc d = desc();
  d.gravity = {0, -10, 0};
  TestWorld test(d);
  NetworkParts parts;
  parts.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  parts.springs = {{0, 1, 10, 1}};
  parts.masses = {1};
  const weft::ClothId cloth = add_network(test, parts);
  test.step(0.01, 100);
  EXPECT_NEAR(test.positions(cloth)[2].y, -5,
              GetParam() == weft::Accumulate::float24_all ? 1e-2 : 1e-4);
}

TEST_P(AllSums, EqualSpringsAreMergedAndPiecesDoNotTouch) {
  TestWorld test(desc());
  NetworkParts parts;
  parts.positions = {{0, 0, 0}, {1.5, 0, 0}, {10, 0, 0}, {11, 0, 0}};
  parts.springs = {{0, 1, 10, 1}, {1, 0, 10, 1}, {2, 3, 10, 1}};
  parts.masses = {1};
  const weft::ClothId cloth = add_network(test, parts);
  const std::vector<Vec> a = test.accelerations(cloth);
  EXPECT_NEAR(a[0].x, 5, GetParam() == weft::Accumulate::fixed8 ? 0.05 : 0.01);
  EXPECT_EQ(a[2].x, 0);
  EXPECT_EQ(a[3].x, 0);
}

TEST_P(AllSums, ClothsOfAllKindsWithoutSpringsOrVerticesStep) {
  TestWorld test(desc());
  test.add(weft::NetworkDesc{}, weft::ClothDesc{});
  weft::GridDesc one;
  one.rows = one.columns = 1;
  test.add(one, weft::ClothDesc{});
  add_particles(test, {{0, 0, 0}, {1, 2, 3}});
  test.step(0.01, 3);
}

TEST_P(AllSums, MomentumStaysInFreeFlight) {
  Sheet sheet;
  sheet.noise = 0.02;
  TestWorld test(desc());
  const weft::ClothId cloth = sheet.add_to(test);
  double largest = 0;
  Vec sum;
  for (Vec a : test.accelerations(cloth)) {
    sum += a;
    largest = std::max(largest, length(a));
  }
  const double within = GetParam() == weft::Accumulate::fixed8    ? 8  // sums saturate
                        : GetParam() == weft::Accumulate::float16 ? 2e-2
                                                                  : 1e-3;
  EXPECT_LE(length(sum) / largest, within);
}

INSTANTIATE_TEST_SUITE_P(Every, AllSums,
                         testing::Values(weft::Accumulate::native, weft::Accumulate::atomic,
                                         weft::Accumulate::fixed64, weft::Accumulate::float16,
                                         weft::Accumulate::float24, weft::Accumulate::float24_all,
                                         weft::Accumulate::fixed8),
                         [](const auto& info) { return std::string(to_string(info.param)); });

TEST(HubMemory, FollowsTheNumberOfSprings) {
  // HC12, HC19: valences from 0 to 1e5 in one mesh; a table of the largest valence takes 40 GB.
  const uint32_t spokes = 100000;
  NetworkParts parts;
  parts.positions = {{0, 0, 0}};
  parts.masses = {1};
  for (uint32_t i = 1; i <= spokes; ++i) {
    parts.positions.push_back({double(i % 317), double(i / 317), 1});
    parts.springs.push_back({0, i, 1, -1});
    if (i > 317 && i % 3 == 0) parts.springs.push_back({i, i - 317, 1, -1});
  }
  parts.positions.push_back({0, 0, 9});  // valence 0
  for (weft::Evaluation e : {weft::Evaluation::gather, weft::Evaluation::scatter}) {
    weft::WorldDesc desc = plain_world(weft::Precision::float32);
    desc.evaluation = e;
    desc.substeps = 0;
    TestWorld test(desc);
    add_network(test, parts);
    test.step(1.0 / 60);
    const double items = double(parts.positions.size() + parts.springs.size());
    EXPECT_LE(double(test.world().stats().bytes_state) / items, 128) << weft::to_string(e);
  }
}

}  // namespace
}  // namespace weft_tests
