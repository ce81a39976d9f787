// Vertex buffers: layouts, origin, interpolation, and what is refused.
#include <cstring>
#include <limits>

#include "reference/refusals.h"
#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

using weft::Attribute;
using weft::Format;
using weft::OutputDesc;

constexpr uint32_t rows = 13, columns = 9, vertices = rows * columns;

weft::GridDesc sheet() {
  weft::GridDesc grid;
  grid.rows = rows;
  grid.columns = columns;
  return grid;
}

/// Two triangles per cell, vertices in an order of their own: storage order is another.
weft::MeshDesc mesh(std::vector<weft::double3>& x, std::vector<uint32_t>& triangles) {
  std::vector<uint32_t> name(vertices);
  for (uint32_t v = 0; v < vertices; ++v)
    name[v] = v * 50 % vertices;  // 50 and 117 share no factor
  x.resize(vertices);
  for (uint32_t v = 0; v < vertices; ++v) {
    x[name[v]] = {double(v % columns) / (columns - 1), double(v / columns) / (rows - 1), 0};
  }
  for (uint32_t r = 0; r + 1 < rows; ++r)
    for (uint32_t c = 0; c + 1 < columns; ++c) {
      const uint32_t a = r * columns + c;
      for (uint32_t v : {a, a + 1, a + columns + 1, a, a + columns + 1, a + columns})
        triangles.push_back(name[v]);
    }
  weft::MeshDesc desc;
  desc.positions = weft::View<weft::double3>(x);
  desc.indices = triangles;
  return desc;
}

class Outputs : public testing::TestWithParam<std::tuple<bool, weft::Precision>> {
 protected:
  Outputs() {
    weft::WorldDesc desc;
    desc.precision = std::get<1>(GetParam());
    desc.interpolate = true;
    world = std::make_unique<TestWorld>(desc);
    weft::ClothDesc cloth;
    const weft::Pin pins[] = {{0}, {columns - 1}};
    cloth.pins = {pins, 2};
    cloth.pose.translate = {1000.25, 3, -7};
    if (std::get<0>(GetParam())) {
      id = world->add(mesh(x, triangles), cloth);
    } else {
      id = world->add(sheet(), cloth);
    }
    world->step(1.0 / 60, 9);
    before = read();
    world->step(1.0 / 60);
    now = read();
    normals.resize(vertices);
    world->check(world->world().read_normals(id, normals.data()));
  }
  std::vector<weft::double3> read() {
    std::vector<weft::double3> out(vertices);
    world->check(world->world().read_positions(id, out.data()));
    return out;
  }
  weft::OutputId bind(const OutputDesc& desc) {
    return world->take(world->world().bind_output(id, desc));
  }

  std::vector<weft::double3> x;
  std::vector<uint32_t> triangles;
  std::unique_ptr<TestWorld> world;
  weft::ClothId id;
  std::vector<weft::double3> before, now, normals;
};

struct Vertex {
  float position[3];
  float uv[2];
  float normal[3];
};

TEST_P(Outputs, InterleavedVerticesKeepWhatLiesBetween) {
  std::vector<Vertex> buffer(vertices + 4);
  std::memset(buffer.data(), 0x5a, buffer.size() * sizeof(Vertex));
  const std::vector<Vertex> untouched = buffer;
  OutputDesc desc;
  desc.layout.position = {Format::f32x3, 0, sizeof(Vertex)};
  desc.layout.normal = {Format::f32x3, 20, sizeof(Vertex)};
  desc.memory = buffer.data();
  desc.bytes = buffer.size() * sizeof(Vertex);
  desc.first_vertex = 3;
  desc.origin = {1000, 0, 0};
  bind(desc);
  world->check(world->world().write_outputs());
  for (uint32_t v = 0; v < vertices; ++v) {
    const Vertex& out = buffer[v + 3];
    EXPECT_EQ(out.position[0], float(now[v].x - 1000)) << v;
    EXPECT_EQ(out.position[1], float(now[v].y)) << v;
    EXPECT_EQ(out.position[2], float(now[v].z)) << v;
    EXPECT_EQ(out.normal[0], float(normals[v].x)) << v;
    EXPECT_EQ(out.normal[1], float(normals[v].y)) << v;
    EXPECT_EQ(out.normal[2], float(normals[v].z)) << v;
    EXPECT_EQ(std::memcmp(out.uv, untouched[0].uv, sizeof out.uv), 0) << v;
  }
  for (size_t outside : {size_t(0), size_t(1), size_t(2), size_t(vertices + 3)})
    EXPECT_EQ(std::memcmp(&buffer[outside], &untouched[0], sizeof(Vertex)), 0) << outside;
}

TEST_P(Outputs, PlanarStreamsAndUnalignedMemory) {
  std::vector<char> memory(1 + vertices * (16 + 12));
  OutputDesc desc;
  desc.layout.position = {Format::f32x4, 1, 16};
  desc.layout.normal = {Format::f32x3, 1 + 16 * vertices, 12};
  desc.memory = memory.data();
  desc.bytes = memory.size();
  bind(desc);
  world->check(world->world().write_outputs());
  for (uint32_t v = 0; v < vertices; ++v) {
    float position[4], normal[3];
    std::memcpy(position, &memory[1 + 16 * v], 16);
    std::memcpy(normal, &memory[1 + 16 * vertices + 12 * v], 12);
    EXPECT_EQ(position[1], float(now[v].y));
    EXPECT_EQ(position[3], 1.0f);
    EXPECT_EQ(normal[2], float(normals[v].z));
  }
}

TEST_P(Outputs, LieBetweenTheLastTwoSteps) {
  std::vector<weft::float3> out(vertices);
  OutputDesc desc;
  desc.layout.position = {Format::f32x3, 0, 12};
  desc.memory = out.data();
  bind(desc);
  double moved = 0;
  for (const double alpha : {0.0, 0.25, 1.0}) {
    world->check(world->world().write_outputs(alpha));
    for (uint32_t v = 0; v < vertices; ++v) {
      EXPECT_NEAR(out[v].x, before[v].x + alpha * (now[v].x - before[v].x), 1e-4);
      EXPECT_NEAR(out[v].y, before[v].y + alpha * (now[v].y - before[v].y), 2e-6) << alpha;
      EXPECT_NEAR(out[v].z, before[v].z + alpha * (now[v].z - before[v].z), 2e-6);
      moved = std::max(moved, std::abs(now[v].y - before[v].y));
    }
  }
  EXPECT_GT(moved, 1e-3);
}

TEST_P(Outputs, BeforeSurvivesAChangeOfTheWorld) {
  std::vector<weft::float3> out(vertices);
  OutputDesc desc;
  desc.layout.position = {Format::f32x3, 0, 12};
  desc.memory = out.data();
  bind(desc);
  world->take(world->world().create_sphere({}));  // the device memory is made anew
  world->check(world->world().write_outputs(0));
  for (uint32_t v = 0; v < vertices; ++v) EXPECT_NEAR(out[v].y, before[v].y, 1e-6);
}

TEST_P(Outputs, LastPositionIsWhatWasWrittenBefore) {
  std::vector<weft::float3> out(2 * vertices);
  OutputDesc desc;
  desc.layout.position = {Format::f32x3, 0, 24};
  desc.layout.last_position = {Format::f32x3, 12, 24};
  desc.memory = out.data();
  bind(desc);
  world->check(world->world().write_outputs());
  std::vector<weft::float3> first(vertices);
  for (uint32_t v = 0; v < vertices; ++v) {
    EXPECT_EQ(out[2 * v].y, out[2 * v + 1].y);
    first[v] = out[2 * v];
  }
  world->step(1.0 / 60);
  world->check(world->world().write_outputs(0.5));
  for (uint32_t v = 0; v < vertices; ++v) {
    EXPECT_EQ(out[2 * v + 1].x, first[v].x);
    EXPECT_EQ(out[2 * v + 1].y, first[v].y);
    EXPECT_EQ(out[2 * v + 1].z, first[v].z);
  }
}

TEST_P(Outputs, BoundsHoldEveryVertexOfBothSteps) {
  const weft::Bounds b = world->take(world->world().bounds(id));
  weft::double3 low = now[0], high = now[0];
  for (const auto* points : {&before, &now})
    for (const weft::double3& p : *points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  EXPECT_NEAR(b.low.x, low.x, 1e-4);
  EXPECT_NEAR(b.low.y, low.y, 1e-6);
  EXPECT_NEAR(b.high.y, high.y, 1e-6);
  EXPECT_NEAR(b.high.z, high.z, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(GridAndMesh, Outputs,
                         testing::Combine(testing::Bool(),
                                          testing::Values(weft::Precision::float32,
                                                          weft::Precision::float64)),
                         [](const testing::TestParamInfo<Outputs::ParamType>& info) {
                           return std::string(std::get<0>(info.param) ? "mesh_" : "grid_") +
                                  weft::to_string(std::get<1>(info.param));
                         });

class BadOutput : public testing::Test {
 protected:
  BadOutput() : cloth(test.add(sheet(), {})), buffer(vertices * 64) {
    good.layout.position = {Format::f32x3, 0, 32};
    good.layout.normal = {Format::f32x3, 12, 32};
    good.memory = buffer.data();
    good.bytes = buffer.size();
  }
  void refused(const OutputDesc& desc, const char* said) {
    test.clear_log();
    EXPECT_EQ(test.world().bind_output(cloth, desc).status(), weft::Status::invalid_argument);
    EXPECT_NE(test.log().find(said), std::string::npos) << test.log();
  }

  TestWorld test;
  weft::ClothId cloth;
  std::vector<char> buffer;
  OutputDesc good;
};

TEST_F(BadOutput, EveryFieldIsChecked) {
  OutputDesc desc = good;
  desc.layout.position.stride = 11;
  refused(desc, "layout.position.stride is 11");
  desc = good;
  desc.layout.position.format = Format::snorm8x4;
  refused(desc, "layout.position has a format of normals");
  desc = good;
  desc.layout.normal.format = Format(99);
  refused(desc, "layout.normal");
  desc = good;
  desc.layout = {};
  refused(desc, "names no attribute");
  desc = good;
  desc.origin.y = std::numeric_limits<double>::quiet_NaN();
  refused(desc, "origin");
  desc = good;
  desc.bytes = 32 * vertices - 9;
  refused(desc, "bytes is");
  desc.first_vertex = 1;
  desc.bytes = 32 * vertices;
  refused(desc, "bytes is");
  desc = good;
  desc.memory = nullptr;
  refused(desc, "memory is null");
  EXPECT_EQ(test.world().bind_output({}, good).status(), weft::Status::invalid_handle);
  test.take(test.world().bind_output(cloth, good));
}

TEST_F(BadOutput, OverlapsAreFoundInEveryArrangement) {
  OutputDesc desc = good;
  desc.layout.normal.offset = 11;
  refused(desc, "overlap");
  desc.layout.normal = {Format::f32x3, 32 + 8, 32};  // of the next vertex
  refused(desc, "overlap");
  desc.layout.normal = {Format::f32x3, 32 * (vertices - 1) + 11, 12};
  refused(desc, "overlap");
  desc.layout.normal = {Format::f32x3, 20, 64};  // another stride, between every other position
  desc.bytes = 0;
  test.take(test.world().bind_output(cloth, desc));
  desc.layout.normal = {Format::f32x3, 20, 44};
  refused(desc, "overlap");
  desc = good;
  desc.bytes = 0;
  desc.layout.position = {Format::f32x3, 12 * vertices, 12};  // planar, normals first
  desc.layout.normal = {Format::f32x3, 0, 12};
  test.take(test.world().bind_output(cloth, desc));
}

TEST_F(BadOutput, WritesNothingWhereItFails) {
  const weft::OutputId id = test.take(test.world().bind_output(cloth, good));
  OutputDesc later = good;
  later.memory = nullptr;
  later.bytes = 0;
  const weft::OutputId without = test.take(test.world().bind_output(cloth, later));
  std::fill(buffer.begin(), buffer.end(), char(7));
  EXPECT_EQ(test.world().write_outputs(), weft::Status::invalid_argument);
  EXPECT_NE(test.log().find("has no memory"), std::string::npos);
  for (const char c : buffer) ASSERT_EQ(c, 7);
  test.check(test.world().set_output_memory(without, buffer.data(), buffer.size()));
  EXPECT_EQ(test.world().set_output_memory(without, buffer.data(), 10),
            weft::Status::invalid_argument);
  for (const double alpha : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(test.world().write_outputs(alpha), weft::Status::invalid_argument) << alpha;
  test.clear_log();
  EXPECT_EQ(test.world().write_outputs(0.5), weft::Status::invalid_argument);
  EXPECT_NE(test.log().find("WorldDesc::interpolate"), std::string::npos);
  for (const char c : buffer) ASSERT_EQ(c, 7);
  test.check(test.world().write_outputs());
  test.check(test.world().unbind_output(id));
  EXPECT_EQ(test.world().unbind_output(id), weft::Status::invalid_handle);
  test.check(test.world().destroy_cloth(cloth));
  EXPECT_EQ(test.world().unbind_output(without), weft::Status::invalid_handle);
  EXPECT_EQ(test.world().bounds(cloth).status(), weft::Status::invalid_handle);
  test.check(test.world().write_outputs());
}

}  // namespace
}  // namespace weft_tests
