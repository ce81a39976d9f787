#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "api/arena/collider_mesh_arrays.h"
#include "api/arena/parts.h"
#include "api/world/call_guard.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"
#include "base/stable_sort_host.h"

namespace weft {

namespace {

/// Adds the time it lives to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum), begin_(std::chrono::steady_clock::now()) {}
  ~Stopwatch() {
    sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  std::chrono::steady_clock::time_point begin_;
};

constexpr double most_table_bytes = 268435456;

/// Offsets of pin motions and turns of colliders are tabled for every substep of a frame.
void check_tables(const plan::WorldShape& shape) {
  const Counts counts = plan::counts_of(shape);
  const double motions = counts.pin_blocks > 0 ? static_cast<double>(counts.motions) : 0;
  const double of_substep = 3 * motions + 9 * static_cast<double>(counts.turns);
  const double bytes = shape.substeps * of_substep * static_cast<double>(shape.scalar());
  if (bytes <= most_table_bytes) return;
  throw InvalidInput(
      text("%u substeps (with moving pins or turning colliders they take tables of %.3g GB, and a "
           "step has %.3g at most) step less far at once",
           shape.substeps, 1e-9 * bytes, 1e-9 * most_table_bytes));
}

bool before_in_arena(const api::ClothRecord* a, const api::ClothRecord* b) {
  return api::kind_of(*a) < api::kind_of(*b);
}

}  // namespace

static Accumulation accumulation_of(Accumulate accumulate) {
  static_assert(int(Accumulation::atomic) == int(Accumulate::atomic) &&
                int(Accumulation::fixed64) == int(Accumulate::fixed64) &&
                int(Accumulation::float16) == int(Accumulate::float16) &&
                int(Accumulation::float24) == int(Accumulate::float24) &&
                int(Accumulation::float24_all) == int(Accumulate::float24_all) &&
                int(Accumulation::fixed8) == int(Accumulate::fixed8));
  return static_cast<Accumulation>(accumulate);
}

inline namespace v0 {

api::ArenaInput World::Impl::arena_input(uint32_t substeps) const {
  api::ArenaInput in;
  in.world = &desc;
  in.colliders = &colliders;
  in.wind = wind ? &*wind : nullptr;
  in.self_collision = self_collision ? &*self_collision : nullptr;
  for (size_t k = 0; k < order.size(); ++k) {
    const ClothId id = order[k];
    cloths[id.index]->created = k;
    // A cloth without vertices has no block; it needs no place.
    if (cloths[id.index]->cooked().vertices > 0) in.cloths.push_back(cloths[id.index].get());
  }
  weft::stable_sort(in.cloths.begin(), in.cloths.end(), before_in_arena);
  plan::WorldShape& shape = in.shape;
  shape.precision = desc.precision;
  shape.position_form = desc.form == Form::position;
  shape.projects = desc.integrator == Integrator::xpbd;
  shape.accumulation = accumulation_of(desc.accumulate);
  shape.full_scale = desc.fixed8_range;
  shape.substeps = std::max(1u, substeps);
  shape.wind = wind.has_value();
  shape.staggered = self_collision && self_collision->search == PairSearch::staggered;
  shape.contact_groups = self_collision && !shape.staggered && self_collision->skin < 0 &&
                         context->backend->info().host_memory;
  shape.contact_grids = !self_collision ? 0 : shape.staggered ? self_collision->grids : 1;
  shape.normals = normals_wanted;
  shape.interpolate = desc.interpolate;
  for (const api::ClothRecord* cloth : in.cloths) {
    shape.cloths.push_back(api::shape_of(*cloth, shape.accumulation, shape.wind || shape.normals));
  }
  api::price_parts(shape);
  // Particle indices are 32 bits wide, guard bands included.
  const auto elements = static_cast<uint64_t>(plan::counts_of(shape).particles);
  if (elements > (uint64_t(1) << 30) + block_size * in.cloths.size()) {
    throw InvalidInput(text("a world of %llu particles (it holds at most 2^30) use several worlds",
                            static_cast<unsigned long long>(elements)));
  }
  for (const api::ColliderRecord& c : colliders) {
    if (!c.id) continue;
    ++shape.colliders[static_cast<int>(c.shape)];
    if (c.can_turn) ++shape.turning_colliders;
    if (c.shape != ColliderShape::mesh) continue;
    const auto at = std::find(in.meshes.begin(), in.meshes.end(), c.cooked_mesh);
    in.mesh_of_collider.push_back(static_cast<size_t>(at - in.meshes.begin()));
    if (at != in.meshes.end()) continue;
    in.meshes.push_back(c.cooked_mesh);
    shape.meshes.push_back(api::grid_counts(*c.cooked_mesh));
  }
  check_tables(shape);
  return in;
}

Status World::Impl::ensure_built(double dt, uint32_t substeps) {
  const bool fits = built && built_substeps >= substeps;
  if (!dirty && fits && (!starting || built_dt == dt)) return Status::ok;
  const api::Zone zone(*context, "weft prepare");
  Stopwatch watch(phases[api::phase_prepare].seconds);
  if (built) {
    const Status status = arena->save(*built);
    if (status != Status::ok) return status;
    built.reset();
    graves.clear();
  }
  dirty = true;
  forget_results();
  api::ArenaInput in = arena_input(substeps);
  const Status status = arena->build(in, dt, time, context->workers());
  if (status != Status::ok) return status;
  starting = false;
  for (api::ClothRecord* cloth : in.cloths) {
    cloth->saved_x = {};
    cloth->saved_d = {};
    cloth->saved_before = {};
    starting |= !cloth->moved;
  }
  built = std::move(in);
  built_dt = dt;
  built_substeps = std::max(1u, substeps);
  dirty = false;
  return Status::ok;
}

Status World::prepare(double dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  return api::guarded(*impl_->context, [&] {
    api::Stride stride;
    const Status status = impl_->stride_of(dt, stride);
    if (status != Status::ok || dt == 0) return status;
    return impl_->ensure_built(stride.dt / stride.substeps, stride.substeps);
  });
}

Status World::Impl::report_not_finite() {
  lost = true;
  try {
    return report_first_not_finite();
  } catch (const std::bad_alloc&) {  // it has diverged all the same
    const Text message = text(
        "a vertex is not finite after %.6g s, and there is no memory to see which (the simulation "
        "diverged) use a shorter step or look for extreme inputs",
        time);
    events.push_back({EventType::non_finite, {}, 0, time, nullptr}, message);
    return context->fail(Status::diverged, message);
  }
}

Status World::Impl::report_first_not_finite() {
  Vector<double3> x;
  for (api::ClothRecord* cloth : built->cloths) {
    if (const Status status = arena->read(*cloth, api::StateArray::position, x);
        status != Status::ok) {
      return status;
    }
    for (uint32_t v = 0; v < x.size(); ++v) {
      if (std::isfinite(x[v].x) && std::isfinite(x[v].y) && std::isfinite(x[v].z)) continue;
      const Text message = text(
          "vertex %u of cloth %u is not finite after %.6g s (the simulation diverged) use a "
          "shorter step or look for extreme inputs",
          v, cloth->id.index, time);
      events.push_back({EventType::non_finite, cloth->id, v, time, nullptr}, message);
      return context->fail(Status::diverged, message);
    }
  }
  return Status::diverged;
}

void World::Impl::begin_events() noexcept {
  if (!lost) events.clear();  // those that say how it was lost stay
}

void World::Impl::drop_time(double seconds, const char* why) {
  time_dropped = std::min(time_dropped + seconds, std::numeric_limits<double>::max());
  events.push_back({EventType::time_dropped, {}, 0, time, why});
}

Status World::Impl::begin(const api::Stride& stride, double way) {
  if (lost) {
    return context->fail(Status::diverged,
                         "the world has diverged (it cannot go on) destroy it and begin anew");
  }
  const Status status = ensure_built(stride.dt / stride.substeps, stride.substeps);
  if (status != Status::ok) return status;
  events.make_room(4 * order.size() + 4);  // whoever sleeps or wakes, and what else may happen
  aim(way);
  wake_by_colliders(stride.dt);
  wake_by_cloths(stride.dt / stride.substeps);
  forget_results();
  if (stride.dropped > 0) {
    drop_time(stride.dropped, "the step took max_substeps and was not as long as asked for");
  }
  flight.dt = stride.dt;
  flight.substeps = stride.substeps;
  flight.way = way;
  return Status::ok;
}

void World::Impl::fly() noexcept {
  flight.seconds = flight.cpu_seconds = 0;
  const MemoryScope scope(&context->memory);
  const api::Zone zone(*context, "weft step");
  const Stopwatch watch(flight.seconds);
  const double sub_dt = flight.dt / flight.substeps;
  const double before = dt_before > 0 ? dt_before : sub_dt;
  Workers workers = context->workers();
  if (desc.profile) workers.clock = &clock;
  workers.cpu_seconds = &flight.cpu_seconds;
  try {
    flight.outcome =
        arena->frame(*built, {static_cast<int>(flight.substeps), sub_dt, before, time, workers});
  } catch (const std::bad_alloc&) {
    flight.outcome = Status::out_of_memory;
  }
}

void World::Impl::tell_who_sleeps(api::ClothRecord& cloth) {
  if (cloth.asleep == cloth.told_asleep) return;
  cloth.told_asleep = cloth.asleep;
  events.push_back({cloth.asleep ? EventType::slept : EventType::woke, cloth.id, 0, time,
                    cloth.asleep ? "the cloth has come to rest" : "the cloth moves again"});
}

Status World::Impl::land() {
  phases[api::phase_inputs_and_advance].seconds += flight.seconds;
  cpu_seconds += flight.cpu_seconds;
  for (int lap = 0; lap < lap_count; ++lap) {
    phases[api::phase_count + lap].seconds = clock.seconds[lap];
  }
  const double dt = flight.dt, sub_dt = dt / flight.substeps;
  if (flight.outcome == Status::out_of_memory) throw std::bad_alloc();
  if (flight.outcome != Status::ok) {
    lost = true;
    return context->fail(flight.outcome,
                         "the device failed during a step (its state is lost) destroy the world");
  }
  if (dt != frame_dt) {
    time_base = time;
    frame_dt = dt;
    frames_of_dt = 0;
  }
  time = time_base + static_cast<double>(++frames_of_dt) * dt;
  dt_before = sub_dt;
  arrive(flight.way);
  for (api::ClothRecord* cloth : built->cloths) {
    if (!cloth->moved) {
      cloth->moved = true;
      cloth->positions = std::pmr::vector<double3>(&context->memory);
      cloth->velocities = std::pmr::vector<double3>(&context->memory);
    }
    tell_who_sleeps(*cloth);  // it may have woken for this step alone
    api::notice_rest(*cloth, dt, sub_dt);
    tell_who_sleeps(*cloth);
    publish_bounds(*cloth);
  }
  starting = false;
  ++frames;
  steps += flight.substeps;
  substeps_last = flight.substeps;
  substeps_most = std::max(substeps_most, flight.substeps);
  dt_least = dt_least > 0 ? std::min(dt_least, sub_dt) : sub_dt;
  threads_last = context->threads;

  Stopwatch watch(phases[api::phase_check].seconds);
  for (const api::ClothRecord* cloth : built->cloths) {
    if (cloth->broken) return report_not_finite();
  }
  if (desc.accumulate == Accumulate::fixed64) {
    const Status status = report_overflow();
    if (status != Status::ok) return status;
  }
  return tell_of_stretch();
}

Status World::Impl::run(const api::Stride& stride, double way) {
  const Status status = begin(stride, way);
  if (status != Status::ok) return status;
  Stopwatch watch(step_seconds);
  fly();
  return land();
}

Status World::step(double dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  return api::guarded(*impl_->context, [&] {
    impl_->begin_events();
    api::Stride stride;
    const Status status = impl_->stride_of(dt, stride);
    if (status != Status::ok || dt == 0) return status;
    return impl_->run(stride, 1);
  });
}

}  // namespace v0
}  // namespace weft
