// Every allocation of a game's life fails once, alone or with all that follow: the call says
// out_of_memory, changes nothing, succeeds when there is memory again, and no bit of what comes
// later differs. All memory passes through the caller's allocator; this program counts operator
// new.
#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>

#include "reference/world_helpers.h"

#include "weft/debug_draw.hpp"
#include "weft/weft.h"

static std::atomic<long> from_heap{0};
static std::atomic<bool> heap_is_empty{false};

static void* counted(std::size_t bytes) {
  if (heap_is_empty) throw std::bad_alloc();
  ++from_heap;
  if (void* memory = std::malloc(bytes ? bytes : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t bytes) { return counted(bytes); }
void* operator new[](std::size_t bytes) { return counted(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace weft_tests {
namespace {

using weft::Status;

/// The allocator: it fails at one call, or at all from there on while it is `armed`.
struct Memory {
  long calls = 0, fails_at = -1, live = 0;
  bool persistent = false, armed = false, has_failed = false;

  static void* allocate(void* user, std::size_t bytes, std::size_t alignment) {
    auto& memory = *static_cast<Memory*>(user);
    if (memory.armed) {
      ++memory.calls;
      if (memory.calls == memory.fails_at ||
          (memory.persistent && memory.fails_at > 0 && memory.calls > memory.fails_at)) {
        memory.has_failed = true;
        return nullptr;
      }
    }
    memory.live += static_cast<long>(bytes);
    return std::aligned_alloc(alignment, (bytes + alignment) / alignment * alignment);
  }
  static void deallocate(void* user, void* at, std::size_t bytes) {
    static_cast<Memory*>(user)->live -= static_cast<long>(bytes);
    std::free(at);
  }
};

/// Makes calls, each again where it has failed for want of memory.
class Caller {
 public:
  explicit Caller(Memory& memory) : memory_(memory) {}

  void call(const char* name, const std::function<Status()>& body, Status wanted = Status::ok) {
    const uint64_t before = state();
    const bool failed_before = memory_.has_failed;
    const long heap_before = from_heap;
    memory_.armed = true;
    Status status = body();
    memory_.armed = false;
    heap += from_heap - heap_before;
    if (memory_.has_failed && !failed_before) {
      memory_.fails_at = -1;
      if (status != wanted) {
        EXPECT_EQ(status, Status::out_of_memory) << name;
        EXPECT_EQ(state(), before) << name << " failed and changed the world";
        status = body();
      } else {  // what destroys needs no memory, and what is wrong is told without
        EXPECT_TRUE(wanted != Status::ok || std::strncmp(name, "destroy", 7) == 0) << name;
      }
      ++failures;
    }
    EXPECT_EQ(status, wanted) << name;
  }

  std::function<uint64_t()> state = [] { return uint64_t{0}; };
  int failures = 0;
  long heap = 0;

 private:
  Memory& memory_;
};

/// Of a call that makes something.
template <class Made, class To>
Status put(weft::Result<Made> made, To& to) {
  if (made) to = std::move(*made);
  return made.status();
}

struct Life {
  uint64_t hash = 0;
  int failures = 0;
  long calls = 0, heap = 0;
};

Life live(long fails_at, bool persistent, weft::Precision precision) {
  Memory memory;
  memory.fails_at = fails_at;
  memory.persistent = persistent;
  Life life;
  {
    Caller caller(memory);
    weft::Context context;
    caller.call("Context::create", [&] {
      weft::ContextDesc desc = TestWorld::one_thread();
      desc.allocator = {&memory, Memory::allocate, Memory::deallocate};
      return put(weft::Context::create(desc), context);
    });
    weft::Fabric sheet, mesh, net;
    weft::GridDesc grid;
    grid.rows = 5;
    grid.columns = 8;
    grid.material.mass.kind = weft::Mass::Kind::density;
    grid.material.mass.value = 0.3;
    caller.call("cook grid", [&] { return put(context.cook(grid), sheet); });
    const weft::float3 corners[] = {{0, 2, 0}, {1, 2, 0}, {1, 2, 1}, {0, 2, 1}, {1, 2, 1}};
    const uint32_t faces[] = {0, 2, 1, 0, 3, 4};
    weft::MeshDesc welded;
    welded.positions = weft::View<weft::float3>(corners, 5);
    welded.indices = {faces, 6};
    welded.bend = true;
    welded.weld_distance = 0.01;
    caller.call("cook mesh", [&] { return put(context.cook(welded), mesh); });
    const weft::double3 places[] = {{0, 3, 0}, {0.5, 3, 0}, {1, 3, 0}};
    const weft::Spring springs[] = {{0, 1}, {1, 2}, {2, 1}};
    weft::NetworkDesc network;
    network.positions = weft::View<weft::double3>(places, 3);
    network.springs = {springs, 3};
    caller.call("cook network", [&] { return put(context.cook(network), net); });
    weft::ColliderMesh ground;
    weft::ColliderMeshDesc ground_desc;
    ground_desc.positions = welded.positions;
    ground_desc.indices = welded.indices;
    caller.call("cook collider mesh", [&] { return put(context.cook(ground_desc), ground); });

    weft::World world;
    weft::WorldDesc world_desc;
    world_desc.precision = precision;
    world_desc.interpolate = true;
    caller.call("create_world", [&] { return put(context.create_world(world_desc), world); });
    std::vector<weft::ClothId> cloths;
    cloths.reserve(3);
    std::vector<weft::double3> points(40);
    caller.state = [&] {
      uint64_t sum = world.stats().frames;
      for (const weft::ClothId id : cloths) {
        sum = 31 * sum + (world.valid(id) ? 1 : 0);
        const auto bounds = world.bounds(id);
        uint64_t bits = 0;
        std::memcpy(&bits, &bounds->low.y, sizeof bits);
        sum = 31 * sum + bits + (*world.asleep(id) ? 7 : 0);
      }
      return 31 * sum + *world.state_hash();
    };
    const weft::Pin pins[] = {{0, 0}, {7}};
    weft::PinMotion motion;
    motion.amplitude = {0, 0.01, 0};
    motion.omega = 5;
    const weft::VertexForce forces[] = {{3, {0, 0.1, 0}}, {1, {0, 0, 0.1}}, {3, {0, 0.1, 0}}};
    for (const weft::Fabric* fabric : {&sheet, &mesh, &net}) {
      caller.call("create_cloth", [&] {
        weft::ClothDesc desc;
        desc.fabric = *fabric;
        desc.drag = 0.01;
        if (fabric == &sheet) {
          desc.pins = {pins, 2};
          desc.motions = {&motion, 1};
          desc.forces = {forces, 3};
          desc.tether_scale = 1.1;
        }
        weft::ClothId id;
        const Status status = put(world.create_cloth(desc), id);
        if (status == Status::ok) cloths.push_back(id);
        return status;
      });
    }
    weft::ColliderId ball, mesh_collider;
    weft::SphereDesc sphere;
    sphere.center = {0.4, -0.4, 0.4};
    sphere.radius = 0.3;
    caller.call("create_sphere", [&] { return put(world.create_sphere(sphere), ball); });
    caller.call("create_mesh", [&] {
      weft::MeshColliderDesc desc;
      desc.mesh = ground;
      desc.pose.translate = {0, -4, 0};
      return put(world.create_mesh(desc), mesh_collider);
    });
    weft::ColliderSetId body;
    const weft::SphereDesc parts[] = {sphere, sphere, sphere};
    weft::ColliderSetDesc body_desc;
    body_desc.spheres = {parts, 3};
    caller.call("create_collider_set",
                [&] { return put(world.create_collider_set(body_desc), body); });
    weft::OutputId output;
    std::vector<char> buffer(40 * 24);
    caller.call("bind_output", [&] {
      weft::OutputDesc desc;
      desc.layout.position = {weft::Format::f32x3, 0, 24};
      desc.layout.last_position = {weft::Format::f32x3, 12, 24};
      desc.memory = buffer.data();
      return put(world.bind_output(cloths[0], desc), output);
    });
    caller.call("set_wind", [&] { return world.set_wind({}); });
    caller.call("prepare", [&] { return world.prepare(1.0 / 60); });
    caller.call("step", [&] { return world.step(1.0 / 60); });
    caller.call("write_outputs", [&] { return world.write_outputs(0.5); });
    caller.call("move_collider", [&] {
      weft::Pose pose;
      pose.degrees = 5;
      return world.move_collider(ball, pose);
    });
    caller.call("move_collider_set", [&] { return world.move_collider_set(body, body_desc); });
    const uint32_t moved[] = {12, 3, 5};
    const weft::double3 targets[] = {{0.6, 0.2, 0}, {0.4, 0.1, 0}, {0.7, 0, 0}};
    const weft::View<weft::double3> to(targets, 3);
    caller.call("move_pins", [&] { return world.move_pins(cloths[0], {moved, 3}, to); });
    caller.call("set_forces", [&] { return world.set_forces(cloths[1], {forces, 3}); });
    caller.call("release_pins", [&] { return world.release_pins(cloths[0], {moved, 1}); });
    caller.call("advance", [&] { return world.advance(1.0 / 30).status(); });
    caller.call("read_velocities", [&] { return world.read_velocities(cloths[0], points.data()); });
    caller.call("read_normals", [&] { return world.read_normals(cloths[1], points.data()); });
    caller.call("mechanics", [&] { return world.mechanics().status(); });
    caller.call("plan", [&] { return world.plan().status(); });
    caller.call("stability", [&] { return world.stability(cloths[2]).status(); });
    caller.call("diagnostics", [&] { return world.diagnostics(cloths[0]).status(); });
    caller.call("debug_draw", [&] {
      weft::DebugDraw draw;
      draw.line = [](void*, weft::double3, weft::double3, uint32_t) {};
      return world.debug_draw(draw);
    });
    // What is wrong is told without memory, too.
    caller.call(
        "a stale id",
        [&] {
          return world.destroy_cloth({3, 3});
        },
        Status::invalid_handle);
    caller.call(
        "step(-1)", [&] { return world.step(-1); }, Status::invalid_argument);
    caller.call("destroy_cloth", [&] { return world.destroy_cloth(cloths[1]); });
    cloths.erase(cloths.begin() + 1);
    caller.call("destroy_collider_set", [&] { return world.destroy_collider_set(body); });
    caller.call("step", [&] { return world.step(1.0 / 60); });
    caller.call("unbind_output", [&] { return world.unbind_output(output); });
    life.hash = *world.state_hash();
    life.failures = caller.failures;
    life.heap = caller.heap;
    EXPECT_LE(std::labs(memory.live - static_cast<long>(context.bytes_allocated())), 4096)
        << "bytes_allocated differs from what the allocator gave by more than the context";
  }
  EXPECT_EQ(memory.live, 0) << "something was not given back";
  life.calls = memory.calls;
  return life;
}

class OutOfMemory : public ::testing::TestWithParam<weft::Precision> {};

TEST_P(OutOfMemory, EveryCallSurvivesEveryFailure) {
  if (!on_host()) GTEST_SKIP() << "the runtime of a GPU has its own ways";
  const Life whole = live(-1, false, GetParam());
  EXPECT_EQ(whole.heap, 0) << "calls of operator new past the allocator";
  EXPECT_GT(whole.calls, 300);
  int failures = 0;
  for (long k = 1; k <= whole.calls; ++k) {
    const Life life = live(k, k % 2 == 0, GetParam());
    ASSERT_EQ(life.hash, whole.hash) << "allocation " << k;
    ASSERT_FALSE(HasFailure()) << "allocation " << k;
    failures += life.failures;
  }
  EXPECT_EQ(failures, whole.calls);
}

INSTANTIATE_TEST_SUITE_P(Precisions, OutOfMemory,
                         ::testing::Values(weft::Precision::float32, weft::Precision::float64));

TEST(OutOfMemory, NothingIsInFlightWhereNoThreadCouldBeMade) {
  auto context = weft::Context::create(TestWorld::one_thread());
  const auto fabric = context->cook(weft::GridDesc());
  auto world = context->create_world();
  weft::ClothDesc cloth;
  cloth.fabric = *fabric;
  ASSERT_TRUE(world->create_cloth(cloth));
  ASSERT_EQ(world->step(1.0 / 60), Status::ok);
  const uint64_t before = *world->state_hash();
  heap_is_empty = true;  // of a step, a thread is all that comes from it
  const Status begun = world->begin_step(1.0 / 60);
  heap_is_empty = false;
  EXPECT_EQ(begun, Status::out_of_memory);
  EXPECT_EQ(world->end_step(), Status::invalid_argument);
  EXPECT_EQ(*world->state_hash(), before);
  ASSERT_EQ(world->begin_step(1.0 / 60), Status::ok);
  ASSERT_EQ(world->end_step(), Status::ok);
  TestWorld other;
  other.add(weft::GridDesc(), {});
  other.step(1.0 / 60, 2);
  EXPECT_EQ(*world->state_hash(), other.hash());
}

TEST(OutOfMemory, ClothsCanBeDestroyedWithoutMemory) {
  if (!on_host()) GTEST_SKIP() << "the runtime of a GPU has its own ways";
  Memory memory;
  weft::ContextDesc desc = TestWorld::one_thread();
  desc.allocator = {&memory, Memory::allocate, Memory::deallocate};
  TestWorld test({}, desc), alone;
  weft::ClothDesc above;
  above.pose.translate = {0, 5, 0};
  const weft::ClothId first = test.add(weft::GridDesc(), {});
  test.add(weft::GridDesc(), above);
  alone.add(weft::GridDesc(), above);
  test.step(1.0 / 60);
  alone.step(1.0 / 60);
  memory.fails_at = memory.calls + 1;
  memory.persistent = memory.armed = true;
  EXPECT_EQ(test.world().destroy_cloth(first), Status::ok);
  EXPECT_FALSE(test.world().valid(first));
  EXPECT_EQ(test.world().step(1.0 / 60), Status::out_of_memory);
  memory.armed = false;
  EXPECT_EQ(test.hash(), alone.hash());
  test.step(1.0 / 60);
  alone.step(1.0 / 60);
  EXPECT_EQ(test.hash(), alone.hash());
}

/// The same in C, to the first failure that a caller meets.
uint64_t live_in_c(Memory& memory, int* refusals) {
  uint64_t hash = 0;
  weft_context* context = nullptr;
  weft_fabric* fabric = nullptr;
  weft_world* world = nullptr;
  weft_cloth_id cloth{};
  weft_context_desc desc = weft_default_context();
  desc.backend = WEFT_BACKEND_OMP;
  desc.threads = 1;
  desc.allocator = {&memory, Memory::allocate, Memory::deallocate};
  weft_grid_desc grid = weft_default_grid();
  grid.rows = grid.columns = 4;
  weft_float3 points[16];
  const std::function<weft_status()> calls[] = {
      [&] { return weft_context_create(&desc, WEFT_C_ABI, &context); },
      [&] { return weft_cook_grid(context, &grid, &fabric); },
      [&] { return weft_world_create(context, nullptr, &world); },
      [&] {
        weft_cloth_desc of = weft_default_cloth();
        of.fabric = fabric;
        return weft_create_cloth(world, &of, &cloth);
      },
      [&] { return weft_step(world, 1.0 / 60); },
      [&] { return weft_read_positions_float(world, cloth, points, sizeof points[0]); },
      [&] { return weft_state_hash(world, &hash); }};
  for (const auto& call : calls) {
    memory.armed = true;
    weft_status status = call();
    memory.armed = false;
    if (status == WEFT_OUT_OF_MEMORY) {
      ++*refusals;
      memory.fails_at = -1;
      status = call();
    }
    EXPECT_EQ(status, WEFT_OK);
  }
  weft_world_release(world);
  weft_fabric_release(fabric);
  EXPECT_EQ(weft_context_bytes(context), 0u);
  weft_context_release(context);
  EXPECT_EQ(memory.live, 0);
  return hash;
}

TEST(OutOfMemory, EveryCallOfCSurvivesEveryFailure) {
  if (!on_host()) GTEST_SKIP() << "the runtime of a GPU has its own ways";
  Memory memory;
  int refusals = 0;
  const long heap = from_heap;
  const uint64_t whole = live_in_c(memory, &refusals);
  EXPECT_LE(from_heap - heap, 7) << "more than the std::functions above";
  ASSERT_EQ(refusals, 0);
  for (long k = 1; k <= memory.calls; ++k) {
    Memory failing;
    failing.fails_at = k;
    failing.persistent = true;
    ASSERT_EQ(live_in_c(failing, &refusals), whole) << k;
    ASSERT_FALSE(HasFailure()) << k;
  }
  EXPECT_EQ(refusals, memory.calls);
}

}  // namespace
}  // namespace weft_tests
