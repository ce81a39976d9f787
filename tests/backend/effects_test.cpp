// Every effect on every back end and memory layout: the same bits (HC76).
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "api/context_state.h"
#include "api/world_state.h"
#include "backends.h"
#include "reference/mesh_shapes.h"
#include "reference/random.h"

namespace weft::testing {
namespace {

struct Stage {
  Context& context;
  World& world;
  std::vector<ClothId> cloths;
  std::vector<ColliderId> colliders;
};

Context context_on(const Backend& backend, uint32_t threads) {
  auto state = std::make_shared<api::ContextState>(ContextDesc{});
  state->backend = &backend;
  state->threads = threads;
  return Context(new Context::Impl{state});
}

std::vector<double3> points_of(const reference::Triangles& mesh) {
  std::vector<double3> points;
  for (const reference::Vec v : mesh.vertices) points.push_back({v.x, v.y, v.z});
  return points;
}

void add_grid(Stage& s, ClothDesc cloth) {
  GridDesc grid;
  grid.rows = 33;
  grid.columns = 47;
  grid.material.stiffness = 60;
  cloth.fabric = *s.context.cook(grid);
  cloth.pose = {{1, 0, 0}, 90, {0, 0.1, 0}};
  s.cloths.push_back(*s.world.create_cloth(cloth));
}
void add_mesh(Stage& s, ClothDesc cloth) {
  const reference::Triangles sheet = reference::sheet(1, 20, 0.05);
  const std::vector<double3> positions = points_of(sheet);
  MeshDesc mesh;
  mesh.positions = View<double3>(positions);
  mesh.indices = View<uint32_t>(sheet.faces[0].data(), 3 * sheet.faces.size());
  mesh.bend = true;
  mesh.material.stiffness = {60, 0, 5};
  mesh.material.mass.kind = Mass::Kind::density;
  mesh.material.mass.value = 0.3;
  cloth.fabric = *s.context.cook(mesh);
  cloth.pose = {{1, 0, 0}, -90, {0.5, 0.3, 0.5}};
  s.cloths.push_back(*s.world.create_cloth(cloth));
}
void add_network(Stage& s, ClothDesc cloth) {
  reference::SplitMix random(4);
  std::vector<double3> positions;
  std::vector<Spring> springs;
  for (uint32_t i = 0; i < 300; ++i) {
    const reference::Vec p = random.noise(0.5) + reference::Vec{0.5, 0.6, 0.5};
    positions.push_back({p.x, p.y, p.z});
    for (uint32_t k = 1; k < 4 && i > k; ++k) springs.push_back({i, uint32_t(i - k), 5, -1});
  }
  NetworkDesc network;
  network.positions = View<double3>(positions);
  network.springs = springs;
  cloth.fabric = *s.context.cook(network);
  s.cloths.push_back(*s.world.create_cloth(cloth));
}
void add_all(Stage& s, const ClothDesc& cloth = {}) {
  add_grid(s, cloth);
  add_mesh(s, cloth);
  add_network(s, cloth);
}

template <class Desc>
Desc rough(Desc desc, double3 velocity = {0, 0, 0}) {
  desc.friction = 0.4;
  desc.velocity = velocity;
  return desc;
}

/// One collider of each shape under the cloths.
void add_colliders(Stage& s, double3 v) {
  World& w = s.world;
  s.colliders = {
      *w.create_sphere(rough(SphereDesc{{0.2, -0.15, 0.2}, 0.2}, v)),
      *w.create_plane(rough(PlaneDesc{{0.1, 1, 0}, -0.3}, v)),
      *w.create_capsule(rough(CapsuleDesc{{0.6, -0.1, 0.1}, {0.9, 0, 0.2}, 0.08}, v)),
      *w.create_cylinder(rough(CylinderDesc{{0.5, -0.2, 0.6}, {0.5, 0.02, 0.5}, 0.1}, v)),
      *w.create_box(rough(BoxDesc{{0.8, -0.1, 0.8}, {0.1, 0.12, 0.1}, {1, 2, 3}, 30}, v))};
}
void add_mesh_colliders(Stage& s, double3 v) {
  for (const bool closed : {true, false}) {
    const reference::Triangles shape =
        closed ? reference::ball(0.2, 2, 0.3) : reference::sheet(0.5, 6, 0.05);
    const std::vector<double3> positions = points_of(shape);
    ColliderMeshDesc mesh;
    mesh.positions = View<double3>(positions);
    mesh.indices = View<uint32_t>(shape.faces[0].data(), 3 * shape.faces.size());
    mesh.thickness = 0.01;
    mesh.closed = closed;
    MeshColliderDesc desc;
    desc.mesh = *s.context.cook(mesh);
    desc.pose = {{1, 0, 0}, closed ? 0. : 80., {closed ? 0.25 : 0.7, -0.12, 0.5}};
    s.colliders.push_back(*s.world.create_mesh(rough(desc, v)));
  }
}
void move_all(Stage& s, int frame) {
  for (const ColliderId id : s.colliders) {
    const Pose pose{{0.2, 1, 0.1}, 1.5 * frame, {0.002 * frame, 0.004 * frame, 0}};
    EXPECT_EQ(s.world.move_collider(id, pose), Status::ok);
  }
}

struct Effect {
  const char* name;
  std::function<void(Stage&)> make;
  std::function<void(Stage&, int frame)> before_step;
  Evaluation evaluation = Evaluation::gather;
  Accumulate accumulate = Accumulate::native;
  int frames = 20;
};

void no_change(Stage&, int) {}

ClothDesc damped() {
  static const VertexForce forces[] = {{7, {0, 0.02, 0.01}}, {40, {0.01, 0, 0}}};
  ClothDesc cloth;
  cloth.drag = 1e-4;
  cloth.spring_damping = 1e-3;
  cloth.forces = View<VertexForce>(forces, 2);
  return cloth;
}
ClothDesc pinned() {
  static const Pin pins[] = {{0, Pin::fixed}, {46, 0}, {20, 1}};
  static const PinMotion motions[] = {{{0.5, 0, 0}, {0, 0.05, 0.1}, 5},
                                      {{0, 0, 0}, {0.1, 0, 0}, 23}};
  ClothDesc cloth;
  cloth.pins = View<Pin>(pins, 3);
  cloth.motions = View<PinMotion>(motions, 2);
  return cloth;
}
ClothDesc sleepy() {
  ClothDesc cloth = damped();
  cloth.drag = 0.05;
  cloth.sleep_speed = 0.2;
  cloth.sleep_time = 0.05;
  return cloth;
}
/// A vertex with more springs than fit into a slice, and into a chunk.
void add_hub(Stage& s, ClothDesc cloth) {
  reference::SplitMix random(8);
  std::vector<double3> positions{{0.5, 0.5, 0.5}};
  std::vector<Spring> springs;
  for (uint32_t i = 1; i < 1500; ++i) {
    const reference::Vec p = random.noise(0.5) + reference::Vec{0.5, 0.6, 0.5};
    positions.push_back({p.x, p.y, p.z});
    springs.push_back({0, i, 0.5, -1});
    if (i > 200) springs.push_back({7, i, 0.5 + 0.1 * (i % 3), -1});
  }
  NetworkDesc network;
  network.positions = View<double3>(positions);
  network.springs = springs;
  cloth.fabric = *s.context.cook(network);
  s.cloths.push_back(*s.world.create_cloth(cloth));
}
/// Every kind of cloth, with all that adds to its forces.
void add_forced(Stage& s) {
  add_all(s, damped());
  add_hub(s, damped());
  EXPECT_EQ(s.world.set_wind({{3, 8, -2}, 1.2, 1, 0.3}), Status::ok);
}
void nudge_pins(Stage& s, int frame) {
  const uint32_t vertices[] = {3, 46};
  const double3 targets[] = {{0.1, 0.1 + 0.01 * frame, 0}, {1, 0.2, 0.02 * frame}};
  for (const ClothId id : s.cloths) {
    Status status = Status::ok;
    if (frame % 4 == 1) {
      status = s.world.move_pins(id, View<uint32_t>(vertices, 2), View<double3>(targets, 2));
    } else if (frame == 14) {
      status = s.world.release_pins(id, View<uint32_t>(vertices, 1));
    }
    EXPECT_EQ(status, Status::ok);
  }
}

const std::vector<Effect>& effects() {
  static const std::vector<Effect> all{
      {"Shapes",
       [](Stage& s) {
         add_all(s), add_colliders(s, {0, 0, 0});
       },
       no_change},
      {"MovingShapes",
       [](Stage& s) {
         add_all(s), add_colliders(s, {0.3, 0.5, 0});
       },
       no_change},
      {"TurningShapes",
       [](Stage& s) {
         add_all(s), add_colliders(s, {0, 0, 0});
       },
       move_all},
      {"FastShapes",
       [](Stage& s) {
         add_all(s), add_colliders(s, {9, 15, 3});
       },
       no_change},
      {"Meshes",
       [](Stage& s) {
         add_all(s), add_mesh_colliders(s, {0, 0, 0});
       },
       no_change},
      {"MovingMeshes",
       [](Stage& s) {
         add_all(s), add_mesh_colliders(s, {0, 0.4, 0.1});
       },
       no_change},
      {"TurningMeshes",
       [](Stage& s) {
         add_all(s), add_mesh_colliders(s, {0, 0, 0});
       },
       move_all},
      {"Wind",
       [](Stage& s) {
         add_all(s);
         EXPECT_EQ(s.world.set_wind({{3, 8, -2}, 1.2, 1, 0.3}), Status::ok);
       },
       [](Stage& s, int frame) {
         if (frame != 10) return;
         EXPECT_EQ(s.world.set_wind({{-3, 2, 5}, 1.2, 0.8, 0}), Status::ok);
       }},
      {"DampingAndForces", [](Stage& s) { add_all(s, damped()); }, no_change},
      {"Pins", [](Stage& s) { add_all(s, pinned()); }, nudge_pins},
      {"Sleep",
       [](Stage& s) {
         add_all(s, sleepy()), add_colliders(s, {0, 0, 0});
       },
       [](Stage& s, int frame) {
         if (frame != 14) return;
         EXPECT_TRUE(*s.world.asleep(s.cloths[0]));
         EXPECT_EQ(s.world.wake(s.cloths[0]), Status::ok);
       }},
      {"Hubs", add_forced, no_change, Evaluation::gather, Accumulate::native, 5},
      {"Scatter", add_forced, no_change, Evaluation::scatter, Accumulate::native, 5},
      {"ScatterSleep",
       [](Stage& s) {
         add_all(s, sleepy()), add_colliders(s, {0, 0, 0});
       },
       no_change, Evaluation::scatter},
      {"ScatterFixed64", add_forced, no_change, Evaluation::scatter, Accumulate::fixed64, 5},
      {"ScatterFloat16", add_forced, no_change, Evaluation::scatter, Accumulate::float16, 5},
      {"ScatterFloat24", add_forced, no_change, Evaluation::scatter, Accumulate::float24, 5},
      {"ScatterFloat24All", add_forced, no_change, Evaluation::scatter, Accumulate::float24_all, 5},
      {"ScatterFixed8", add_forced, no_change, Evaluation::scatter, Accumulate::fixed8, 5},
  };
  return all;
}

/// All that a caller can read after the frames of an effect.
struct Outcome {
  std::vector<uint64_t> hashes;
  std::vector<double3> vectors;  // normals, velocities, accelerations

  bool operator==(const Outcome& o) const {
    return hashes == o.hashes && vectors.size() == o.vectors.size() &&
           std::memcmp(vectors.data(), o.vectors.data(), vectors.size() * sizeof(double3)) == 0;
  }
};

Outcome outcome(const Effect& effect, const Backend& backend, Precision precision, Form form,
                uint32_t threads) {
  Context context = context_on(backend, threads);
  WorldDesc desc;
  desc.precision = precision;
  desc.form = form;
  desc.evaluation = effect.evaluation;
  desc.accumulate = effect.accumulate;
  desc.deterministic = effect.accumulate != Accumulate::atomic;
  World world = std::move(*context.create_world(desc));
  Stage stage{context, world, {}, {}};
  effect.make(stage);
  Outcome out;
  for (int frame = 1; frame <= effect.frames; ++frame) {
    effect.before_step(stage, frame);
    EXPECT_EQ(world.step(1.0 / 60), Status::ok);
    if (frame % 5 != 0) continue;
    out.hashes.push_back(*world.state_hash());
    for (const ClothId id : stage.cloths) out.hashes.push_back(*world.asleep(id));
  }
  std::vector<double3> values(33 * 47);
  for (const ClothId id : stage.cloths) {
    for (const auto read :
         {+[](World&w, ClothId c, double3*to) { return w.read_normals(c, to); },
          +[](World&w, ClothId c, double3*to) { return w.read_velocities(c, to); },
          +[](World&w, ClothId c, double3*to) { return w.read_accelerations(c, to); }}) {
      values.assign(values.size(), {0, 0, 0});
      EXPECT_EQ(read(world, id, values.data()), Status::ok);
      out.vectors.insert(out.vectors.end(), values.begin(), values.end());
    }
  }
  return out;
}

class Effects : public ::testing::TestWithParam<size_t> {};

TEST_P(Effects, HaveTheSameBitsOnEveryBackend) {
  const Effect& effect = effects()[GetParam()];
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Form form : {Form::summed, Form::position}) {
      const Outcome expected = outcome(effect, *backends()[0].backend, precision, form, 1);
      // Each copy with one thread, too: layout_test.cpp.
      for (const NamedBackend& other : backends()) {
        EXPECT_TRUE(outcome(effect, *other.backend, precision, form, 3) == expected)
            << other.name << " " << to_string(precision)
            << (form == Form::summed ? " summed" : " position");
      }
    }
  }
}

const Effect& effect_named(const std::string& name) {
  for (const Effect& effect : effects()) {
    if (name == effect.name) return effect;
  }
  throw std::runtime_error(name);
}

TEST(Evaluations, NativeScatterHasTheBitsOfTheGatherOnEveryBackend) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Form form : {Form::summed, Form::position}) {
      const Outcome gather =
          outcome(effect_named("Hubs"), *backends()[0].backend, precision, form, 1);
      for (const NamedBackend& other : backends()) {
        EXPECT_TRUE(outcome(effect_named("Scatter"), *other.backend, precision, form, 2) == gather)
            << other.name << " " << to_string(precision);
      }
    }
  }
}

TEST(Evaluations, AtomicSumsRunOnEveryBackend) {
  Effect effect = effect_named("Scatter");
  effect.accumulate = Accumulate::atomic;
  for (const NamedBackend& other : backends()) {
    const Outcome out = outcome(effect, *other.backend, Precision::float64, Form::summed, 2);
    const Outcome native =
        outcome(effect_named("Scatter"), *other.backend, Precision::float64, Form::summed, 2);
    ASSERT_EQ(out.vectors.size(), native.vectors.size());
    double furthest = 0;  // velocities: the second third of what was read
    for (size_t i = out.vectors.size() / 3; i < 2 * out.vectors.size() / 3; ++i) {
      furthest = std::max(furthest, std::abs(out.vectors[i].y - native.vectors[i].y));
    }
    EXPECT_LE(furthest, 1e-6) << other.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Effects, ::testing::Range(size_t(0), effects().size()),
                         [](const auto& info) { return std::string(effects()[info.param].name); });

}  // namespace
}  // namespace weft::testing
