#include <algorithm>
#include <bit>
#include <cmath>

#include "api/arena/image.h"
#include "api/arena/tethers.h"
#include "api/world/call_guard.h"
#include "plan/device_arrays.h"
#include "api/records/evaluation.h"
#include "api/world/state.h"
#include "scene/energy.h"

namespace weft {
inline namespace v0 {

/// Before the first step any step will do to hold the start: a step of another length remakes it.
Status World::Impl::ensure_readable() {
  if (built && !dirty) return Status::ok;
  const double dt = built_dt > 0 ? built_dt : std::min(1.0 / 60, desc.safety * tightest().dt_bound);
  return ensure_built(dt, std::max(1u, built_substeps));
}

Status World::Impl::make_result(api::StateArray which) {
  const Result wanted = which == api::StateArray::acceleration ? Result::accelerations
                        : which == api::StateArray::normal     ? Result::normals
                                                               : Result::none;
  if (wanted == Result::none || wanted == result) return Status::ok;
  const double dt = dt_before > 0 ? dt_before : built_dt;
  Status status = wanted == Result::normals
                      ? arena->normals(*built, context->workers())
                      : arena->accelerations(*built, built_dt, dt, context->workers());
  if (status == Status::ok && wanted == Result::accelerations) {
    api::Overflow found;
    status = find_overflow(found);
    if (status == Status::diverged) status = context->fail(status, found.text);
  }
  result = status == Status::ok ? wanted : Result::none;
  return status;
}

void World::Impl::want_normals() {
  if (normals_wanted) return;
  normals_wanted = true;
  for (const ClothId id : order) {
    const scene::CookedFabric& fabric = find(id)->cooked();
    dirty |= !fabric.is_grid && !fabric.triangles.empty() && !wind;
  }
}

/// Reads one cloth and hands every vertex's value to `use`.
template <class Use>
static Status read_cloth(World::Impl* impl, ClothId id, api::StateArray which, Use use) {
  const api::CallGuard guard(impl);
  if (!guard) return guard.status();
  api::ClothRecord* cloth = impl->find(id);
  if (!cloth) return impl->stale("cloth", id.index);
  return api::guarded(*impl->context, [&] {
    Vector<double3> values;
    Status status = impl->ensure_readable();
    if (status == Status::ok) status = impl->make_result(which);
    if (status == Status::ok && cloth->cooked().vertices > 0) {
      status = impl->arena->read(*cloth, which, values);
    }
    if (status != Status::ok) return status;
    for (uint32_t v = 0; v < values.size(); ++v) use(*cloth, v, values[v]);
    return status;
  });
}

/// Hands out vectors, `stride` bytes apart; `what` names them in messages.
template <class Point>
static Status read_points(World::Impl* impl, ClothId id, api::StateArray which, const char* what,
                          Point* out, uint32_t stride, const char* call = __builtin_FUNCTION()) {
  const api::CallGuard guard(impl, id, call);
  if (!guard) return guard.status();
  if (const api::ClothRecord* cloth = impl->find(id);
      cloth && cloth->cooked().vertices > 0 && (!out || stride < sizeof(Point))) {
    return impl->context->fail(
        Status::invalid_argument,
        text("%s into %s with a stride of %u bytes (a point takes %zu) "
             "give a buffer and its stride",
             what, out ? "a buffer" : "a null pointer", stride, sizeof(Point)));
  }
  if (which == api::StateArray::normal && impl->find(id)) impl->want_normals();
  const bool local = which == api::StateArray::position;
  return read_cloth(
      impl, id, which, [&](const api::ClothRecord& cloth, uint32_t v, const double3& value) {
        const double3 x = local ? api::plus(cloth.origin, value) : value;
        char* at = reinterpret_cast<char*>(out) + size_t(v) * stride;
        auto* p = reinterpret_cast<Point*>(at);
        using Scalar = decltype(p->x);
        *p = {static_cast<Scalar>(x.x), static_cast<Scalar>(x.y), static_cast<Scalar>(x.z)};
      });
}

Status World::read_positions(ClothId id, double3* out, uint32_t stride) noexcept {
  return read_points(impl_, id, api::StateArray::position, "positions", out, stride);
}
Status World::read_positions(ClothId id, float3* out, uint32_t stride) noexcept {
  return read_points(impl_, id, api::StateArray::position, "positions", out, stride);
}

template <class Point>
static Status read_normals(World::Impl* impl, ClothId id, Point* out, uint32_t stride) {
  const api::CallGuard guard(impl, id);
  if (!guard) return guard.status();
  return read_points(impl, id, api::StateArray::normal, "normals", out, stride);
}
Status World::read_normals(ClothId id, double3* out, uint32_t stride) noexcept {
  return weft::read_normals(impl_, id, out, stride);
}
Status World::read_normals(ClothId id, float3* out, uint32_t stride) noexcept {
  return weft::read_normals(impl_, id, out, stride);
}

Status World::read_accelerations(ClothId id, double3* out) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  if (impl_->find(id) && !out) {
    return impl_->context->fail(
        Status::invalid_argument,
        "accelerations into a null pointer (there is no room) give a buffer");
  }
  return read_cloth(impl_, id, api::StateArray::acceleration,
                    [&](const api::ClothRecord&, uint32_t v, const double3& a) { out[v] = a; });
}

Status World::Impl::probe(const api::ClothRecord& cloth, Vector<api::Probed>& out) {
  out.clear();
  bool holds = api::TethersPart::used(cloth) || self_collision.has_value();
  for (const api::ColliderRecord& c : colliders) holds |= bool(c.id);
  // Before the first step the displacement is that of the velocity that was given.
  if (!holds || !cloth.moved || cloth.asleep) return Status::ok;
  if (!probed) {
    const double part = 1.0 / substeps_last;
    Vector<api::ColliderRecord> on(colliders.begin(), colliders.end());
    for (api::ColliderRecord& c : on) {
      c.gliding = c.went;
      c.since = c.went ? time : c.since;
      // One substep on: the arena may have been made anew for fewer than the last step had.
      if (c.went) c.target = api::between(c.placed, api::continued(c.was, c.placed), part);
    }
    api::ArenaInput in = *built;
    in.colliders = &on;
    const Status status = arena->probe(in, {1, dt_before, dt_before, time, context->workers()});
    if (status != Status::ok) return status;
    probed = true;
  }
  return arena->read_probe(cloth, out);
}

Status World::Impl::read_mean_velocities(ClothId id, double3* out) {
  return read_cloth(this, id, api::StateArray::displacement,
                    [&](const api::ClothRecord& cloth, uint32_t v, const double3& d) {
                      const double dt = cloth.moved ? dt_before : built_dt;
                      out[v] = cloth.asleep ? double3{0, 0, 0} : api::times(1 / dt, d);
                      const api::PinRecord* pin = cloth.pin_of(v);
                      if (pin && pin->motion >= 0) {
                        out[v] = api::motion_velocity(cloth.motions[size_t(pin->motion)], time);
                      }
                    });
}

/// v = (d_n + d_(n+1))/2dt. Where nothing but forces acts on a vertex that is d/dt + a dt/2 with
/// every force of the scheme: lagged drag acts on d/dt, central drag on v.
Status World::read_velocities(ClothId id, double3* out) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  if (impl_->find(id) && !out) {
    return impl_->context->fail(Status::invalid_argument,
                                "velocities into a null pointer (there is no room) give a buffer");
  }
  // XPBD knows no more than where it has gone: its springs are no forces.
  if (impl_->desc.integrator == Integrator::xpbd) return impl_->read_mean_velocities(id, out);
  Vector<double3> a;
  const Status status = read_cloth(
      impl_, id, api::StateArray::acceleration,
      [&](const api::ClothRecord&, uint32_t, const double3& value) { a.push_back(value); });
  if (status != Status::ok) return status;
  Vector<api::Probed> next;
  const Status probing = api::guarded(*impl_->context, [&] {
    const api::ClothRecord& cloth = *impl_->find(id);
    return cloth.cooked().vertices > 0 ? impl_->probe(cloth, next) : Status::ok;
  });
  if (probing != Status::ok) return probing;
  return read_cloth(impl_, id, api::StateArray::displacement,
                    [&](const api::ClothRecord& cloth, uint32_t v, const double3& d) {
                      const double dt = cloth.moved ? impl_->dt_before : impl_->built_dt;
                      const double3 backward = api::times(1 / dt, d);
                      if (const api::PinRecord* pin = cloth.pin_of(v)) {
                        const bool moves = pin->motion >= 0;
                        out[v] = moves ? api::motion_velocity(cloth.motions[size_t(pin->motion)],
                                                              impl_->time)
                                       : backward;
                        return;
                      }
                      if (cloth.asleep) {
                        out[v] = {0, 0, 0};
                        return;
                      }
                      if (!next.empty() && next[v].held) {
                        out[v] = api::times(0.5 / dt, api::plus(d, next[v].displacement));
                        return;
                      }
                      const double half_g = 0.5 * cloth.drag * dt / cloth.cooked().mass_of(v);
                      const double3 kick = api::times(dt / 2, a[v]);
                      if (cloth.drag_model == DragModel::lagged) {
                        out[v] = api::plus(api::times(1 - half_g, backward), kick);
                      } else {
                        out[v] = api::times(1 / (1 + half_g), api::plus(backward, kick));
                      }
                    });
}

Result<Mechanics> World::mechanics() noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  Mechanics sum{0, 0, 0, {0, 0, 0}, 0};
  for (const ClothId id : impl_->order) {
    const api::ClothRecord& cloth = *impl_->find(id);
    Status status = api::guarded(*impl_->context, [&] {
      const uint32_t n = cloth.cooked().vertices;
      Vector<double3> x(n), v(n), rest(n);
      if (n == 0) return Status::ok;
      Status read = read_positions(id, x.data());
      if (read == Status::ok) read = read_velocities(id, v.data());
      if (read != Status::ok) return read;
      scene::Array<uint8_t> pinned(n, 0, &impl_->context->memory);
      for (const api::PinRecord& pin : cloth.pins) pinned[pin.vertex] = 1;
      for (uint32_t i = 0; i < n; ++i) rest[i] = api::posed(cloth, i);
      const scene::Energies e =
          scene::energies({cloth.cooked(), x, v, &pinned, impl_->desc.gravity, rest});
      sum.kinetic += e.kinetic;
      sum.elastic += e.elastic;
      sum.potential += e.potential;
      sum.momentum = api::plus(sum.momentum, e.momentum);
      sum.stretch = std::max(sum.stretch, e.stretch);
      return Status::ok;
    });
    if (status != Status::ok) return status;
  }
  return sum;
}

namespace {

class Fnv1a {
 public:
  template <class Bits>
  void add(Bits bits) {
    for (size_t byte = 0; byte < sizeof(Bits); ++byte) {
      hash_ = (hash_ ^ ((bits >> (8 * byte)) & 0xff)) * 0x100000001b3ull;
    }
  }
  uint64_t value() const { return hash_; }

 private:
  uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace

Result<uint64_t> World::state_hash() noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  Fnv1a hash;
  const bool wide = impl_->desc.precision == Precision::float64;
  for (const ClothId id : impl_->order) {
    const Status status =
        read_cloth(impl_, id, api::StateArray::position,
                   [&](const api::ClothRecord& cloth, uint32_t, const double3& local) {
                     const double3 x = api::plus(cloth.origin, local);
                     for (const double c : {x.x, x.y, x.z}) {
                       if (wide) {
                         hash.add(std::bit_cast<uint64_t>(c));
                       } else {
                         hash.add(std::bit_cast<uint32_t>(static_cast<float>(c)));
                       }
                     }
                   });
    if (status != Status::ok) return status;
  }
  return hash.value();
}

Stability World::stability() noexcept {
  Stability none{INFINITY, {}, 0, 0};
  const api::CallGuard guard(impl_);
  if (!guard) return none;
  Stability found = none;
  const Status status = api::guarded(*impl_->context, [&] {
    found = impl_->tightest();
    return Status::ok;
  });
  return status == Status::ok ? found : none;
}

Result<Stability> World::stability(ClothId id) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  const Status status = api::guarded(*impl_->context, [&] {
    impl_->bound_of(*cloth);
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return Stability{cloth->bound_dt, id, cloth->bound_a, cloth->bound_b};
}

Result<PlanInfo> World::plan() noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  PlanInfo info{};
  const Status status = api::guarded(*impl_->context, [&] {
    const api::ArenaInput in =
        impl_->arena_input(std::max(impl_->built_substeps, impl_->desc.substeps));
    impl_->plan = plan::compile_plan(in.shape);
    impl_->passes.clear();
    for (const plan::Pass& p : impl_->plan.passes) {
      impl_->passes.push_back(
          {p.stage, p.per, p.kernel.c_str(), p.count, p.bytes_per_particle, p.flops_per_particle});
    }
    info.passes = {impl_->passes.data(), impl_->passes.size()};
    impl_->evaluations.clear();
    for (const ClothId id : impl_->order) {
      const api::ClothRecord& cloth = *impl_->cloths[id.index];
      const plan::EvaluationCost cost =
          api::cost_of(cloth, impl_->desc.precision, impl_->context->backend->info());
      impl_->evaluations.push_back({id, cloth.scatters ? Evaluation::scatter : Evaluation::gather,
                                    cost.gather, cost.scatter});
    }
    info.evaluations = {impl_->evaluations.data(), impl_->evaluations.size()};
    info.bytes_state = plan::device_bytes(in.shape, impl_->context->backend->info().vector_stride);
    const uint64_t list = static_cast<uint64_t>(plan::first_list_entries(in.shape)) *
                          plan::list_entry_bytes(in.shape);
    const uint64_t list_now = impl_->built && list > 0 ? impl_->arena->list_bytes() : 0;
    info.bytes_state += std::max(list, list_now);
    return Status::ok;
  });
  if (status != Status::ok) return status;
  const uint64_t arena_now = impl_->built ? impl_->arena->bytes() : 0;
  info.bytes_total = impl_->context->memory.held() - arena_now + info.bytes_state;
  return info;
}

void World::Impl::publish() const noexcept {
  Stats s{};
  s.frames = frames;
  s.steps = steps;
  s.substeps_last = substeps_last;
  s.substeps_most = substeps_most;
  s.dt_last = dt_before;
  s.dt_least = dt_least;
  s.step_seconds = step_seconds;
  s.cpu_seconds = cpu_seconds;
  s.time_dropped = time_dropped;
  s.threads = threads_last;
  const int shown = desc.profile ? api::phases_with_laps : api::phase_count;
  s.phases = {phases, static_cast<size_t>(shown)};
  s.bytes_state = built ? arena->bytes() : 0;
  told.set(s, time, events.view());
}

Stats World::stats() const noexcept {
  if (!impl_) return {};
  Stats s = impl_->told.stats();
  s.bytes_total = impl_->context->memory.held();
  return s;
}

View<Event> World::events() const noexcept { return impl_ ? impl_->told.events() : View<Event>(); }

double World::time() const noexcept { return impl_ ? impl_->told.time() : 0; }

}  // namespace v0
}  // namespace weft
