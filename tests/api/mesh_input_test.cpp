// What a mesh brings besides its triangles: copies of them, springs beside the edges, places.
#include <cmath>
#include <string>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

/// Three rows of three vertices, eight triangles.
struct Sheet {
  std::vector<weft::double3> x;
  std::vector<uint32_t> triangles;
  std::vector<weft::Spring> springs;

  Sheet() {
    for (uint32_t v = 0; v < 9; ++v) x.push_back({0.5 * (v % 3), 0.5 * (v / 3), 0});
    for (const uint32_t a : {0u, 1u, 3u, 4u}) {
      for (const uint32_t v : {a, a + 1, a + 4, a, a + 4, a + 3}) triangles.push_back(v);
    }
  }
  weft::MeshDesc desc() const {
    weft::MeshDesc d;
    d.positions = weft::View<weft::double3>(x);
    d.indices = triangles;
    d.springs = springs;
    d.bend = true;
    d.material.stiffness = 30;
    d.material.mass = {weft::Mass::Kind::density, 3, {}};
    return d;
  }
};

std::vector<std::string> texts(const weft::Fabric& fabric) {
  std::vector<std::string> out;
  for (uint32_t i = 0; i < fabric.diagnostics().count; ++i) {
    out.push_back(fabric.diagnostics()[i].text);
  }
  return out;
}
bool tells(const weft::Fabric& fabric, const std::string& part) {
  for (const std::string& text : texts(fabric)) {
    if (text.find(part) != std::string::npos) return true;
  }
  return false;
}

struct Measured {
  uint64_t triangles, springs;
  double mass, push;  ///< kg; N of a wind along z
  std::vector<weft::double3> normals;
};

Measured measure(const weft::MeshDesc& desc) {
  weft::WorldDesc world = plain_world(weft::Precision::float64);
  world.gravity = {0, 0, 0};
  TestWorld test(world);
  const weft::Fabric fabric = test.cook(desc);
  weft::ClothDesc cloth;
  cloth.fabric = fabric;
  const weft::ClothId id = test.add(cloth);
  Measured m{fabric.triangle_count(), fabric.spring_count(), 0, 0, {}};
  m.normals.resize(fabric.vertex_count());
  test.check(test.world().read_normals(id, m.normals.data()));
  test.check(test.world().set_gravity({0, -1, 0}));
  const double y = test.world().mechanics()->potential;
  std::vector<weft::double3> x(fabric.vertex_count());
  test.check(test.world().read_positions(id, x.data()));
  m.mass = y;  // of one shape: sums of m y compare as masses do
  test.check(test.world().set_gravity({0, 0, 0}));
  weft::WindDesc wind;
  wind.velocity = {0, 0, 4};
  wind.tangential = 0;
  test.check(test.world().set_wind(wind));
  test.check(test.world().step(1e-5));
  m.push = test.world().mechanics()->momentum.z / 1e-5;
  return m;
}

TEST(MeshInput, TrianglesThatAreGivenAgainCountOnce) {
  const Sheet once;
  const Measured expected = measure(once.desc());
  EXPECT_NEAR(expected.push, 0.5 * 1.225 * 1 * 16, 1e-2) << "rho A u^2/2";
  for (int way = 0; way < 4; ++way) {
    Sheet twice;
    for (size_t t = 0; t < once.triangles.size(); t += 3) {
      const uint32_t* v = &once.triangles[t];
      const bool reversed = way == 1 || (way == 2 && t % 2 == 1);
      if (way == 3 && t != 9) continue;
      if (reversed)
        twice.triangles.insert(twice.triangles.end(), {v[2], v[1], v[0]});
      else
        twice.triangles.insert(twice.triangles.end(), {v[1], v[2], v[0]});
    }
    const Measured same = measure(twice.desc());
    EXPECT_EQ(same.triangles, 8u) << way;
    EXPECT_EQ(same.springs, expected.springs) << "bend springs are there";
    EXPECT_EQ(same.mass, expected.mass);
    EXPECT_NEAR(same.push, expected.push, 1e-12);
    for (size_t v = 0; v < 9; ++v) EXPECT_EQ(same.normals[v].z, 1) << v;
    TestWorld test;
    EXPECT_TRUE(tells(test.cook(twice.desc()), "are given again, the first is 8, which is")) << way;
  }
}

// Of a pair the copy may come first the wrong way round: neighbours that are given once decide.
TEST(MeshInput, ACopyTheOtherWayRoundTurnsNothing) {
  const Sheet once;
  Sheet mixed;
  mixed.triangles.insert(mixed.triangles.begin(),
                         {once.triangles[2], once.triangles[1], once.triangles[0]});
  const Measured same = measure(mixed.desc());
  EXPECT_EQ(same.triangles, 8u);
  for (const weft::double3& n : same.normals) EXPECT_EQ(n.z, 1);
}

TEST(MeshInput, CopiesOnWeldedVerticesCountOnce) {
  const Sheet once;
  Sheet twice;
  for (const weft::double3& p : once.x) twice.x.push_back({p.x + 1e-6, p.y, p.z});
  for (size_t t = 0; t < once.triangles.size(); t += 3) {
    const uint32_t* v = &once.triangles[t];
    twice.triangles.insert(twice.triangles.end(), {v[0] + 9, v[2] + 9, v[1] + 9});
  }
  weft::MeshDesc desc = twice.desc();
  EXPECT_EQ(measure(desc).triangles, 16u);
  desc.weld_distance = 1e-5;
  const Measured same = measure(desc), expected = measure(once.desc());
  EXPECT_EQ(same.triangles, 8u);
  EXPECT_EQ(same.springs, expected.springs);
  EXPECT_NEAR(same.push, expected.push, 1e-12);
}

// Two sheets on one edge, folded back onto each other: their areas cancel there.
TEST(MeshInput, NormalsThatCancelAreZero) {
  for (const auto precision : {weft::Precision::float32, weft::Precision::float64}) {
    TestWorld test(plain_world(precision));
    Sheet fold;
    fold.x = {{0.1, 0.2, 0.3}, {1.1, 0.4, 0.7}, {0.3, 1.3, 0.2}, {0.3, 1.3, 0.2}};
    fold.triangles = {0, 1, 2, 1, 0, 3};
    weft::MeshDesc desc = fold.desc();
    desc.material.mass = {weft::Mass::Kind::total, 1, {}};
    weft::ClothDesc cloth;
    cloth.fabric = test.cook(desc);
    const weft::ClothId id = test.add(cloth);
    weft::double3 n[4];
    test.check(test.world().read_normals(id, n));
    for (const int v : {0, 1})
      EXPECT_EQ(std::fabs(n[v].x) + std::fabs(n[v].y) + std::fabs(n[v].z), 0);
    for (const int v : {2, 3}) EXPECT_NEAR(std::hypot(n[v].x, n[v].y, n[v].z), 1, 1e-6);
  }
}

TEST(MeshInput, SpringsJoinWhatNoEdgeJoins) {
  TestWorld test(plain_world(weft::Precision::float64));
  Sheet sheet;
  const uint64_t edges = test.cook(sheet.desc()).spring_count();
  sheet.springs = {{0, 8, -1, -1}, {2, 6, 5, 0.25}};
  weft::Fabric fabric = test.cook(sheet.desc());
  EXPECT_EQ(fabric.spring_count(), edges + 2);
  EXPECT_TRUE(texts(fabric).empty());

  sheet.springs.push_back({8, 0, 7, -1});
  sheet.springs.push_back({1, 0, -1, -1});
  fabric = test.cook(sheet.desc());
  EXPECT_EQ(fabric.spring_count(), edges + 2) << "an edge already, and one that comes again";
  EXPECT_TRUE(tells(fabric,
                    "2 springs join two vertices that an edge or a spring joins already, "
                    "the first is "));

  // Energy of the two when all is stretched to twice its size: k (l - l0)^2/2.
  Sheet bare;
  sheet.springs.resize(2);
  const auto elastic = [&](const Sheet& s) {
    weft::ClothDesc cloth;
    cloth.fabric = test.cook(s.desc());
    std::vector<weft::double3> wide;
    for (const weft::double3& p : s.x) wide.push_back({2 * p.x, 2 * p.y, 0});
    cloth.positions = weft::View<weft::double3>(wide);
    const double before = test.world().mechanics()->elastic;
    test.add(cloth);
    return test.world().mechanics()->elastic - before;
  };
  const double l = std::sqrt(2.0);
  const double first = 0.5 * 30 * l * l, second = 0.5 * 5 * (2 * l - 0.25) * (2 * l - 0.25);
  EXPECT_NEAR(elastic(sheet) - elastic(bare), first + second, 1e-9);
}

TEST(MeshInput, SpringsAreChecked) {
  TestWorld test;
  for (const weft::Spring bad :
       {weft::Spring{0, 9, -1, -1}, weft::Spring{3, 3, -1, -1},
        weft::Spring{0, 8, std::nan(""), -1}, weft::Spring{0, 8, -1, -2}}) {
    Sheet sheet;
    sheet.springs = {{0, 8, -1, -1}, bad};
    EXPECT_EQ(test.context().cook(sheet.desc()).status(), weft::Status::invalid_argument);
  }
}

TEST(MeshInput, LinesAloneAreANetwork) {
  TestWorld test;
  Sheet net;
  net.triangles.clear();
  net.springs = {{0, 1, -1, -1}, {1, 2, -1, -1}};
  weft::MeshDesc desc = net.desc();
  EXPECT_EQ(test.context().cook(desc).status(), weft::Status::invalid_argument)
      << "no triangle has an area for the density";
  desc.material.mass = {weft::Mass::Kind::total, 9, {}};
  const weft::Fabric fabric = test.cook(desc);
  EXPECT_EQ(fabric.spring_count(), 2u);
  EXPECT_EQ(fabric.triangle_count(), 0u);
  EXPECT_TRUE(tells(fabric, "6 vertices belong to no triangle and no spring, the first is 3 "));
}

TEST(MeshInput, ASpringThatLosesAnEndToWeldingIsReported) {
  TestWorld test;
  Sheet sheet;
  sheet.x.push_back({1 + 1e-6, 1, 0});
  sheet.springs = {{8, 9, -1, -1}, {0, 9, -1, -1}};
  weft::MeshDesc desc = sheet.desc();
  const uint64_t edges = test.cook(Sheet().desc()).spring_count();
  desc.weld_distance = 1e-4;
  const weft::Fabric fabric = test.cook(desc);
  EXPECT_EQ(fabric.vertex_count(), 9u);
  EXPECT_EQ(fabric.spring_count(), edges + 1);
  EXPECT_TRUE(tells(fabric, "1 springs lost an end to welding"));
}

// "Nearer than": at exactly the distance two vertices stay two.
TEST(MeshInput, AtExactlyTheDistanceNothingIsWelded) {
  TestWorld test;
  Sheet sheet;
  sheet.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.25, 0, 0}, {1.25, 1, 0}, {0, 1.25, 0}};
  sheet.triangles = {0, 1, 2, 3, 4, 5};
  for (const int axis : {0, 1, 2}) {
    Sheet turned = sheet;
    for (weft::double3& p : turned.x) {
      for (int k = 0; k < axis; ++k) p = {p.z, p.x, p.y};
    }
    weft::MeshDesc desc = turned.desc();
    desc.weld_distance = 0.25;
    EXPECT_EQ(test.cook(desc).vertex_count(), 6u) << axis;
    desc.weld_distance = std::nextafter(0.25, 1);
    EXPECT_EQ(test.cook(desc).vertex_count(), 4u) << axis;
  }
}

}  // namespace
}  // namespace weft_tests
