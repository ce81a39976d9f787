// A render mesh with seams: welded, it moves as the mesh without seams does.
#include <cmath>
#include <limits>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

constexpr uint32_t n = 12;

struct Mesh {
  std::vector<weft::float3> x;
  std::vector<uint32_t> triangles;
  weft::MeshDesc desc() const {
    weft::MeshDesc d;
    d.positions = weft::View<weft::float3>(x);
    d.indices = triangles;
    d.bend = true;
    return d;
  }
};

weft::float3 place(uint32_t c, uint32_t r) { return {float(c) / (n - 1), float(r) / (n - 1), 0}; }

Mesh whole() {
  Mesh m;
  for (uint32_t v = 0; v < n * n; ++v) m.x.push_back(place(v % n, v / n));
  for (uint32_t r = 0; r + 1 < n; ++r)
    for (uint32_t c = 0; c + 1 < n; ++c) {
      const uint32_t a = r * n + c;
      for (uint32_t v : {a, a + 1, a + n + 1, a, a + n + 1, a + n}) m.triangles.push_back(v);
    }
  return m;
}

/// Every triangle with three vertices of its own, a little off: seams everywhere.
Mesh torn(const Mesh& m, float off) {
  Mesh t;
  for (size_t i = 0; i < m.triangles.size(); ++i) {
    weft::float3 p = m.x[m.triangles[i]];
    p.x += off * float(int(i * 7 % 5) - 2) / 2;
    t.x.push_back(p);
    t.triangles.push_back(uint32_t(i));
  }
  return t;
}

TEST(Welding, MakesOneParticleOfEverySeam) {
  const Mesh m = whole(), t = torn(m, 0);
  TestWorld test, seamless;
  weft::MeshDesc desc = t.desc();
  desc.weld_distance = 1e-4;
  weft::ClothDesc cloth, plain;
  cloth.fabric = test.cook(desc);
  plain.fabric = seamless.cook(m.desc());
  EXPECT_EQ(cloth.fabric.vertex_count(), n * n);
  EXPECT_EQ(cloth.fabric.render_vertex_count(), t.x.size());
  EXPECT_EQ(cloth.fabric.spring_count(), plain.fabric.spring_count());
  std::vector<uint32_t> particle(t.x.size());
  test.check(cloth.fabric.read_particles(particle.data()));
  std::vector<uint32_t> particle_of_vertex(n * n);
  for (size_t i = 0; i < t.triangles.size(); ++i) particle_of_vertex[m.triangles[i]] = particle[i];

  const weft::Pin pins[] = {{particle_of_vertex[0]}, {particle_of_vertex[n - 1]}};
  const weft::Pin plain_pins[] = {{0}, {n - 1}};
  cloth.pins = {pins, 2};
  plain.pins = {plain_pins, 2};
  const weft::ClothId a = test.add(cloth), b = seamless.add(plain);
  std::vector<weft::float3> out(t.x.size()), normals(t.x.size());
  weft::OutputDesc output;
  output.layout.position = {weft::Format::f32x3, 0, 12};
  output.memory = out.data();
  output.bytes = out.size() * 12;
  test.take(test.world().bind_output(a, output));
  output.layout = {};
  output.layout.normal = {weft::Format::f32x3, 0, 12};
  output.memory = normals.data();
  test.take(test.world().bind_output(a, output));
  test.step(1.0 / 60, 12);
  seamless.step(1.0 / 60, 12);
  test.check(test.world().write_outputs());
  const std::vector<Vec> reference = seamless.positions(b, n * n);
  std::vector<weft::double3> reference_normals(n * n);
  seamless.check(seamless.world().read_normals(b, reference_normals.data()));
  for (size_t i = 0; i < out.size(); ++i) {
    const Vec& x = reference[m.triangles[i]];
    EXPECT_NEAR(out[i].x, x.x, 1e-4);
    EXPECT_NEAR(out[i].y, x.y, 1e-4);
    EXPECT_NEAR(out[i].z, x.z, 1e-4);
    EXPECT_NEAR(normals[i].z, reference_normals[m.triangles[i]].z, 1e-3);
  }
}

TEST(Welding, TheDistanceDecides) {
  TestWorld test;
  const Mesh t = torn(whole(), 1e-3f);
  weft::MeshDesc desc = t.desc();
  desc.weld_distance = 2.5e-3;
  EXPECT_EQ(test.cook(desc).vertex_count(), n * n);
  desc.weld_distance = 1e-5;
  EXPECT_GT(test.cook(desc).vertex_count(), 2 * n * n);
  desc.weld_distance = 0;
  EXPECT_EQ(test.cook(desc).vertex_count(), t.x.size());
  desc.material.scale = 10;  // the distance is of the scaled shape
  desc.weld_distance = 2.5e-2;
  EXPECT_EQ(test.cook(desc).vertex_count(), n * n);
}

TEST(Welding, TrianglesThatLoseACornerAreReported) {
  TestWorld test;
  weft::MeshDesc desc = whole().desc();
  const Mesh m = whole();
  desc = m.desc();
  desc.weld_distance = 1.05 / (n - 1);
  const weft::Fabric fabric = test.cook(desc);
  EXPECT_LT(fabric.vertex_count(), n * n);
  EXPECT_LT(fabric.triangle_count(), m.triangles.size() / 3);
  bool told = false;
  for (uint32_t i = 0; i < fabric.diagnostics().count; ++i)
    told |= std::string(fabric.diagnostics()[i].text).find("lost a corner") != std::string::npos;
  EXPECT_TRUE(told);
}

TEST(Welding, BadDistancesAreRefused) {
  TestWorld test;
  const Mesh m = whole();
  weft::MeshDesc desc = m.desc();
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e-300}) {
    desc.weld_distance = bad;
    EXPECT_EQ(test.context().cook(desc).status(), weft::Status::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace weft_tests
