// Vertex normals against an independent sum over triangles (HC06, HC07).
#include "reference/effects.h"
#include "reference/grid.h"
#include "reference/random.h"

#include <cstddef>

namespace weft_tests {
namespace {

using Normals = BothPrecisions;

std::vector<Vec> reference_normals(const Triangles& mesh) {
  std::vector<Vec> sum(mesh.vertices.size());
  for (const auto& [i, j, k] : mesh.faces) {
    const Vec a = mesh.vertices[i], n = cross(mesh.vertices[j] - a, mesh.vertices[k] - a);
    for (const uint32_t vertex : {i, j, k}) sum[vertex] += n;
  }
  for (Vec& n : sum)
    if (length(n) > 0) n = (1 / length(n)) * n;
  return sum;
}

std::vector<Vec> read(TestWorld& test, weft::ClothId cloth, size_t count) {
  std::vector<weft::double3> out(count);
  test.check(test.world().read_normals(cloth, out.data()));
  return from_weft(out);
}

/// Positions that float32 holds exactly.
Triangles rounded(Triangles mesh) {
  for (Vec& x : mesh.vertices) x = reference::through_float(x);
  return mesh;
}
Triangles folded_sheet() {
  Triangles mesh = reference::sheet(1, 12, 0);
  for (Vec& x : mesh.vertices) x = x.x > 0 ? Vec{0.02 * x.x, x.y, x.x} : x;
  return rounded(mesh);
}
Triangles crumpled_sheet() {
  Triangles mesh = reference::sheet(1, 12, 0.1);
  reference::SplitMix random(3);
  for (Vec& x : mesh.vertices) x += random.noise(0.02);
  return rounded(mesh);
}
weft::ClothId add(TestWorld& test, const Triangles& mesh) {
  return add_mesh_cloth(test, mesh, slack(weft::Mass::Kind::total, 1));
}

TEST_P(Normals, AreThoseOfTheReferenceOnEverySurface) {
  for (const Triangles& mesh : {rounded(reference::sheet(1, 12, 0)), folded_sheet(),
                                crumpled_sheet(), rounded(reference::ball(0.7, 3))}) {
    TestWorld test(plain_world(GetParam()));
    const std::vector<Vec> n = read(test, add(test, mesh), mesh.vertices.size());
    const std::vector<Vec> expected = reference_normals(mesh);
    for (size_t i = 0; i < n.size(); ++i)
      expect_near(n[i], expected[i], GetParam() == weft::Precision::float64 ? 1e-12 : 3e-6);
  }
}

TEST_P(Normals, OfAFlatSheetAreExactAndThoseOfABallPointOut) {
  TestWorld test(plain_world(GetParam()));
  const Triangles sheet = reference::sheet(1, 8, 0), ball = rounded(reference::ball(0.7, 4));
  const weft::ClothId flat = add(test, sheet), round = add(test, ball);
  for (const Vec n : read(test, flat, sheet.vertices.size()))
    expect_near(n, {0, 0, 1}, GetParam() == weft::Precision::float64 ? 1e-15 : 1e-7);
  const std::vector<Vec> n = read(test, round, ball.vertices.size());
  for (size_t i = 0; i < n.size(); ++i) {
    EXPECT_NEAR(length(n[i]), 1, 1e-6);
    EXPECT_GT(dot(n[i], ball.vertices[i]), 0.699);
  }
}

TEST_P(Normals, OfReversedTrianglesAreExactlyOpposite) {
  Triangles mesh = crumpled_sheet(), reversed = mesh;
  for (auto& face : reversed.faces) std::swap(face[1], face[2]);
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId a = add(test, mesh), b = add(test, reversed);
  const size_t count = mesh.vertices.size();
  const std::vector<Vec> n = read(test, a, count), back = read(test, b, count);
  for (size_t i = 0; i < count; ++i) {
    EXPECT_EQ(n[i].x, -back[i].x);
    EXPECT_EQ(n[i].y, -back[i].y);
    EXPECT_EQ(n[i].z, -back[i].z);
  }
}

TEST_P(Normals, OfTheMirrorImageAreTheMirroredOppositesExactly) {
  Triangles mesh = crumpled_sheet(), image = mesh;
  for (Vec& x : image.vertices) x.x = -x.x;
  const size_t count = mesh.vertices.size();
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId a = add(test, mesh), b = add(test, image);
  const std::vector<Vec> n = read(test, a, count), m = read(test, b, count);
  for (size_t i = 0; i < count; ++i) {
    EXPECT_EQ(m[i].x, n[i].x);
    EXPECT_EQ(m[i].y, -n[i].y);
    EXPECT_EQ(m[i].z, -n[i].z);
  }
}

TEST_P(Normals, OfDegenerateTrianglesAreZeroOrUnit) {
  Triangles mesh;
  mesh.vertices = {{0, 0, 0},    {1, 0, 0},     {2, 0, 0},    {2, 0, 0}, {0, 1, 0},
                   {1, 1e-6, 0}, {5, 5, 5},     {0, 3, 0},    {1, 3, 0}, {0.5, 3, 1e-20},
                   {0, 4, 0},    {1e-25, 4, 0}, {0, 4, 1e-25}};
  mesh.faces = {{0, 1, 2}, {1, 2, 3}, {0, 1, 4}, {0, 1, 5}, {7, 8, 9}, {10, 11, 12}};
  TestWorld test(plain_world(GetParam()));
  const std::vector<Vec> n = read(test, add(test, mesh), mesh.vertices.size());
  ASSERT_TRUE(all_finite(n));
  for (const Vec v : n) EXPECT_TRUE(length(v) == 0 || std::abs(length(v) - 1) < 1e-6) << length(v);
  for (const size_t vertex : {2u, 3u, 6u}) EXPECT_EQ(length(n[vertex]), 0);
  expect_near(n[4], {0, 0, 1}, 1e-7);
}

TEST_P(Normals, OfNetworksAreZero) {
  TestWorld test(plain_world(GetParam()));
  for (const Vec n : read(test, add_particles(test, {{0, 0, 0}, {1, 2, 3}}), 2))
    EXPECT_EQ(length(n), 0);
}

TEST_P(Normals, OfAGridAreThoseOfItsTriangles) {
  for (const auto& [rows, columns] :
       {std::pair{2u, 2u}, {9u, 14u}, {33u, 31u}, {1u, 5u}, {5u, 1u}}) {
    weft::GridDesc grid;
    grid.rows = rows;
    grid.columns = columns;
    grid.material.stiffness = 0;
    std::vector<Vec> x = reference::grid_positions(rows, columns);
    reference::SplitMix random(11);
    for (Vec& p : x) {
      p += random.noise(0.2 / columns);
      p = reference::through_float(p);
    }
    const std::vector<weft::double3> start = to_weft(x);
    weft::ClothDesc desc;
    desc.positions = weft::View<weft::double3>(start);
    TestWorld test(plain_world(GetParam()));
    const weft::ClothId cloth = test.add(grid, desc);
    const std::vector<Vec> expected = reference_normals(triangles_of(test.cook(grid), x));
    const std::vector<Vec> n = read(test, cloth, x.size());
    for (size_t i = 0; i < n.size(); ++i)
      expect_near(n[i], expected[i], GetParam() == weft::Precision::float64 ? 1e-12 : 3e-6);
  }
}

TEST_P(Normals, AreWrittenWithAnyStrideAsFloatsAndDoubles) {
  struct Vertex {
    float uv[2];
    weft::float3 normal;
    double tag;
    weft::double3 wide;
  };
  const Triangles mesh = crumpled_sheet();
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add(test, mesh);
  const std::vector<Vec> n = read(test, cloth, mesh.vertices.size());
  std::vector<Vertex> out(n.size(), Vertex{{7, 8}, {}, 9, {}});
  test.check(test.world().read_normals(cloth, &out[0].normal, sizeof(Vertex)));
  test.check(test.world().read_normals(cloth, &out[0].wide, sizeof(Vertex)));
  for (size_t i = 0; i < n.size(); ++i) {
    EXPECT_TRUE(same_bits(from_weft(out[i].wide), n[i]));
    EXPECT_EQ(out[i].normal.x, float(n[i].x));
    EXPECT_EQ(out[i].normal.y, float(n[i].y));
    EXPECT_EQ(out[i].normal.z, float(n[i].z));
    EXPECT_TRUE(out[i].uv[0] == 7 && out[i].uv[1] == 8 && out[i].tag == 9);
  }
  EXPECT_EQ(test.world().read_normals(cloth, &out[0].wide, sizeof(weft::double3) - 1),
            weft::Status::invalid_argument);
  EXPECT_EQ(test.world().read_normals(cloth, static_cast<weft::float3*>(nullptr)),
            weft::Status::invalid_argument);
}

/// Two hanging sheets of which one falls asleep at once.
std::vector<weft::ClothId> add_sheets(TestWorld& test) {
  std::vector<weft::ClothId> ids;
  for (const double sleep_speed : {0.0, 1e3}) {
    weft::GridDesc grid;
    grid.rows = grid.columns = 11;
    const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {10, weft::Pin::fixed}};
    weft::ClothDesc desc;
    desc.pins = pins;
    desc.sleep_speed = sleep_speed;
    desc.sleep_time = 0.1;
    ids.push_back(test.add(grid, desc));
  }
  return ids;
}

TEST_P(Normals, ReadingThemChangesNoBitOfTheFollowingSteps) {
  weft::WorldDesc desc;
  desc.precision = GetParam();
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    desc.form = form;
    TestWorld read_often(desc), never(desc);
    const std::vector<weft::ClothId> ids = add_sheets(read_often);
    add_sheets(never);
    for (int n = 0; n < 30; ++n) {
      if (n % 3 != 0)
        for (const weft::ClothId id : ids) read(read_often, id, 121);
      read_often.step(1.0 / 60);
      never.step(1.0 / 60);
      ASSERT_TRUE(n % 3 != 1 || read_often.hash() == never.hash()) << n;
    }
    EXPECT_TRUE(read_often.take(read_often.world().asleep(ids[1])));
    EXPECT_FALSE(read_often.take(read_often.world().asleep(ids[0])));
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Normals, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
