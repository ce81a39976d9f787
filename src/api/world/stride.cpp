// How long a step may be, and how many substeps it takes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "api/context/vector_math.h"
#include "api/records/projection.h"
#include "api/world/call_guard.h"
#include "api/world/state.h"
#include "scene/stability.h"

namespace weft {

namespace {

constexpr double shortest_substep = 1e-15;
constexpr double most_substeps = 1e9;
/// Of XPBD, however small a cloth is.
constexpr double least_substeps = 4;

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

}  // namespace

inline namespace v0 {

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
  const bool as_forces = desc.integrator == Integrator::verlet;
  const scene::Bound bound =
      scene::stable_bound(cloth.cooked(), {cloth.pins.empty() ? nullptr : &pinned, lagged,
                                           as_forces ? cloth.spring_damping : 0, blown, as_forces});
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

Text World::Impl::bound_text(const Stability& bound, double dt, uint32_t substeps) {
  const double enough = fewest_substeps(dt, bound.dt_bound);
  if (bound.a == bound.b) {
    return text(
        "%u substeps of %.6g s (the stable bound is %.6g s, set by the drag of vertex %u of cloth "
        "%u) use at least %.0f substeps, or allow unsafe steps",
        substeps, dt / substeps, bound.dt_bound, bound.a, bound.cloth.index, enough);
  }
  return text(
      "%u substeps of %.6g s (the stable bound is %.6g s, set by the spring %u-%u of cloth %u) "
      "use at least %.0f substeps, or allow unsafe steps",
      substeps, dt / substeps, bound.dt_bound, bound.a, bound.b, bound.cloth.index, enough);
}

Status World::Impl::stride_of(double dt, api::Stride& stride) {
  if (!std::isfinite(dt) || dt < 0 || std::fpclassify(dt) == FP_SUBNORMAL) {
    throw InvalidInput(
        text("a step of %g s (time runs forward, in ordinary numbers) give a finite dt >= 0", dt));
  }
  const Stability bound = tightest();
  stride = {dt, desc.substeps, 0};
  if (desc.substeps == 0) {
    const double limit = desc.safety * bound.dt_bound;
    double wanted = limit, n = 1;
    if (desc.integrator == Integrator::xpbd) {
      n = least_substeps;
      for (const ClothId id : order) {
        wanted = std::min(wanted, api::usual_substep(desc, *cloths[id.index]));
      }
    }
    n = std::max(n, fewest_substeps(dt, wanted));
    if (desc.max_substeps > 0 && n > desc.max_substeps) {
      n = desc.max_substeps;
      if (dt / n > limit) stride.dt = n * limit;
      while (stride.dt / n > limit) stride.dt = std::nextafter(stride.dt, 0.0);
      stride.dropped = dt - stride.dt;
    }
    if (!(n <= most_substeps)) {
      throw InvalidInput(
          text("a step of %g s takes %.3g substeps (at most 1e9) step less far at once, or set "
               "max_substeps",
               dt, n));
    }
    stride.substeps = static_cast<uint32_t>(n);
  }
  const double sub_dt = stride.dt / stride.substeps;
  if (dt > 0 && sub_dt < shortest_substep) {
    throw InvalidInput(
        text("a substep of %g s (the shortest is 1e-15 s) step further at once", sub_dt));
  }
  if (sub_dt > bound.dt_bound && !desc.unsafe) {
    return context->fail(Status::unstable_step, bound_text(bound, dt, stride.substeps));
  }
  return Status::ok;
}

Result<uint32_t> World::substeps(double dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  api::Stride stride;
  const Status status = api::guarded(*impl_->context, [&] { return impl_->stride_of(dt, stride); });
  if (status != Status::ok) return status;
  return stride.substeps;
}

}  // namespace v0
}  // namespace weft
