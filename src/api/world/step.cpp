#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "api/arena/collider_mesh_arrays.h"
#include "api/arena/parts.h"
#include "api/world/call_guard.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"
#include "scene/stability.h"

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

constexpr double shortest_substep = 1e-15;
constexpr double most_substeps = 1e9;

/// The fewest substeps of a frame with dt / n <= limit; beyond most_substeps the size is all that
/// counts.
double fewest_substeps(double dt, double limit) {
  double n = std::max(1.0, std::ceil(dt / limit));
  if (!(n <= most_substeps)) return n;
  // The division may have rounded to either side.
  if (dt / n > limit) n += 1;
  if (n > 1 && dt / (n - 1) <= limit) n -= 1;
  return n;
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
  for (const ClothId id : order) {
    // A cloth without vertices has no block; it needs no place.
    if (cloths[id.index]->cooked().vertices > 0) in.cloths.push_back(cloths[id.index].get());
  }
  std::stable_sort(in.cloths.begin(), in.cloths.end(), before_in_arena);
  plan::WorldShape& shape = in.shape;
  shape.precision = desc.precision;
  shape.position_form = desc.form == Form::position;
  shape.accumulation = accumulation_of(desc.accumulate);
  shape.full_scale = desc.fixed8_range;
  shape.substeps = std::max(1u, substeps);
  shape.wind = wind.has_value();
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
  }
  dirty = true;
  result = Result::none;
  probed = false;
  api::ArenaInput in = arena_input(substeps);
  const double before = dt_before > 0 ? dt_before : dt;
  const Status status = arena->build(in, before, time, context->workers());
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

api::ClothRecord& World::Impl::bound_of(api::ClothRecord& cloth) {
  if (cloth.bound_known) return cloth;
  scene::Array<uint8_t> pinned(&context->memory);
  if (!cloth.pins.empty()) {
    pinned.assign(cloth.cooked().vertices, 0);
    for (const api::PinRecord& pin : cloth.pins) pinned[pin.vertex] = 1;
  }
  const double lagged = cloth.drag_model == DragModel::lagged ? cloth.drag : 0;
  double blown = 0;
  if (wind) {
    const double speed = api::length(wind->velocity) + api::length(cloth.velocity);
    blown = speed * wind->air_density * std::max(wind->normal, wind->tangential) / 12;
  }
  const scene::Bound bound = scene::stable_bound(
      cloth.cooked(),
      {cloth.pins.empty() ? nullptr : &pinned, lagged, cloth.spring_damping, blown});
  cloth.bound_dt = bound.dt;
  cloth.bound_a = bound.a;
  cloth.bound_b = bound.b;
  cloth.bound_known = true;
  return cloth;
}

Stability World::Impl::tightest() {
  Stability least{std::numeric_limits<double>::infinity(), {}, 0, 0};
  for (const ClothId id : order) {
    const api::ClothRecord& cloth = bound_of(*cloths[id.index]);
    if (cloth.bound_dt < least.dt_bound) {
      least = {cloth.bound_dt, id, cloth.bound_a, cloth.bound_b};
    }
  }
  return least;
}

std::string World::Impl::bound_text(const Stability& bound, double dt, uint32_t substeps) {
  return text(
      "%u substeps of %.6g s (the stable bound is %.6g s, set by the spring %u-%u of cloth %u) "
      "use at least %.0f substeps, or allow unsafe steps",
      substeps, dt / substeps, bound.dt_bound, bound.a, bound.b, bound.cloth.index,
      fewest_substeps(dt, bound.dt_bound));
}

Result<uint32_t> World::substeps(double dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  uint32_t count = 0;
  const Status status = api::guarded(*impl_->context, [&] {
    if (!std::isfinite(dt) || dt < 0 || std::fpclassify(dt) == FP_SUBNORMAL) {
      throw InvalidInput(
          text("a step of %g s (time runs forward, in ordinary numbers) give a finite "
               "dt >= 0",
               dt));
    }
    const Stability bound = impl_->tightest();
    double n = impl_->desc.substeps;
    if (n == 0) n = fewest_substeps(dt, impl_->desc.safety * bound.dt_bound);
    if (!(n <= most_substeps)) {
      throw InvalidInput(
          text("a step of %g s takes %.3g substeps (at most 1e9) step less far at once", dt, n));
    }
    count = static_cast<uint32_t>(n);
    if (dt > 0 && dt / n < shortest_substep) {
      throw InvalidInput(
          text("a substep of %g s (the shortest is 1e-15 s) step further at once", dt / n));
    }
    if (dt / n > bound.dt_bound && !impl_->desc.unsafe) {
      return impl_->context->fail(Status::unstable_step, impl_->bound_text(bound, dt, count));
    }
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return count;
}

Status World::prepare(double dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  Result<uint32_t> n = substeps(dt);
  if (!n) return n.status();
  if (dt == 0) return Status::ok;
  return api::guarded(*impl_->context, [&] { return impl_->ensure_built(dt / *n, *n); });
}

Status World::Impl::report_not_finite() {
  lost = true;
  std::vector<double3> x;
  for (api::ClothRecord* cloth : built->cloths) {
    if (const Status status = arena->read(*cloth, api::StateArray::position, x);
        status != Status::ok) {
      return status;
    }
    for (uint32_t v = 0; v < x.size(); ++v) {
      if (std::isfinite(x[v].x) && std::isfinite(x[v].y) && std::isfinite(x[v].z)) continue;
      std::string message = text(
          "vertex %u of cloth %u is not finite after %.6g s (the simulation diverged) use a "
          "shorter step or look for extreme inputs",
          v, cloth->id.index, time);
      event_records.push_back({{EventType::non_finite, cloth->id, v, time, nullptr}, message});
      events.push_back(event_records.back().event);
      events.back().text = event_records.back().text.c_str();
      return context->fail(Status::diverged, message);
    }
  }
  return Status::diverged;
}

Status World::Impl::begin(double dt, uint32_t substeps) {
  events.clear();
  event_records.clear();
  if (lost) {
    return context->fail(Status::diverged,
                         "the world has diverged (it cannot go on) destroy it and begin anew");
  }
  const Status status = ensure_built(dt / substeps, substeps);
  if (status != Status::ok) return status;
  wake_by_colliders(dt);
  result = Result::none;
  probed = false;
  flight.dt = dt;
  flight.substeps = substeps;
  return Status::ok;
}

void World::Impl::fly() noexcept {
  flight.seconds = 0;
  const api::Zone zone(*context, "weft step");
  const Stopwatch watch(flight.seconds);
  const double sub_dt = flight.dt / flight.substeps;
  const double before = dt_before > 0 ? dt_before : sub_dt;
  Workers workers = context->workers();
  if (desc.profile) workers.clock = &clock;
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
  for (api::ClothRecord* cloth : built->cloths) {
    if (!cloth->moved) {
      cloth->moved = true;
      cloth->positions = std::pmr::vector<double3>(&context->memory);
      cloth->velocities = std::pmr::vector<double3>(&context->memory);
    }
    for (api::PinRecord& pin : cloth->pins) {
      if (pin.gliding) pin.base = pin.target;
      pin.gliding = false;
    }
    api::notice_rest(*cloth, dt, sub_dt);
    tell_who_sleeps(*cloth);
    publish_bounds(*cloth);
  }
  for (api::ColliderRecord& c : colliders) {
    c.went = c.id && c.gliding;
    if (!c.went) continue;
    c.was = c.placed;
    c.placed = c.target;
    c.since = time;
    c.gliding = false;
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

Status World::Impl::run(double dt, uint32_t substeps) {
  const Status status = begin(dt, substeps);
  if (status != Status::ok) return status;
  fly();
  return land();
}

Status World::step(double dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  Result<uint32_t> n = substeps(dt);
  if (!n) return n.status();
  if (dt == 0) return Status::ok;
  Stopwatch watch(impl_->step_seconds);
  return api::guarded(*impl_->context, [&] { return impl_->run(dt, *n); });
}

}  // namespace v0
}  // namespace weft
