// One scene on every back end and memory layout: grid, mesh, network, damping, moving pins,
// colliders.
#include <gtest/gtest.h>

#include "api/context/context_state.h"
#include "api/world/state.h"
#include "backends.h"

namespace weft::testing::layout {
namespace {

Context context_on(const Backend& backend, uint32_t threads) {
  auto state = std::make_shared<api::ContextState>(ContextDesc{});
  state->backend = &backend;
  state->threads = threads;
  return Context(new Context::Impl{state});
}

void add_grid(Context& context, World& world) {
  GridDesc grid;
  grid.rows = 33;
  grid.columns = 47;
  Pin pins[] = {{0, Pin::fixed}, {46, 0}};
  PinMotion motion;
  motion.amplitude = {0, 0.05, 0.1};
  motion.omega = 5;
  VertexForce force{200, {0, 0, 0.05}};
  ClothDesc cloth;
  cloth.fabric = *context.cook(grid);
  cloth.pins = View<Pin>(pins, 2);
  cloth.motions = View<PinMotion>(&motion, 1);
  cloth.forces = View<VertexForce>(&force, 1);
  cloth.drag = 1e-4;
  cloth.spring_damping = 1e-3;
  ASSERT_TRUE(world.create_cloth(cloth));
}

void add_ball_of_triangles(Context& context, World& world) {
  std::vector<double3> positions{{0, 0.3, 0.2}, {0.1, 0.3, 0.2}, {0, 0.4, 0.2}, {0.05, 0.35, 0.3}};
  std::vector<uint32_t> indices{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  MeshDesc mesh;
  mesh.positions = View<double3>(positions);
  mesh.indices = indices;
  ClothDesc cloth;
  cloth.fabric = *context.cook(mesh);
  cloth.velocity = {0.2, -1, 0};
  ASSERT_TRUE(world.create_cloth(cloth));
}

uint64_t hash_on(const Backend& backend, Precision precision, Form form, uint32_t threads) {
  Context context = context_on(backend, threads);
  WorldDesc desc;
  desc.precision = precision;
  desc.form = form;
  World world = std::move(*context.create_world(desc));
  add_grid(context, world);
  add_ball_of_triangles(context, world);
  SphereDesc sphere;
  sphere.center = {0.5, 0.5, -0.3};
  sphere.radius = 0.25;
  EXPECT_TRUE(world.create_sphere(sphere));
  PlaneDesc plane;
  plane.offset = -0.2;
  EXPECT_TRUE(world.create_plane(plane));
  for (int frame = 0; frame < 30; ++frame) EXPECT_EQ(world.step(1.0 / 60), Status::ok);
  return *world.state_hash();
}

TEST(Layout, NoLayoutLevelOrThreadCountChangesABit) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Form form : {Form::summed, Form::position}) {
      const uint64_t expected = hash_on(*backends()[0].backend, precision, form, 1);
      for (const NamedBackend& other : backends()) {
        for (const uint32_t threads : {1u, 3u}) {
          EXPECT_EQ(hash_on(*other.backend, precision, form, threads), expected)
              << other.name << " " << threads << " threads " << to_string(precision);
        }
      }
    }
  }
}

}  // namespace
}  // namespace weft::testing::layout
