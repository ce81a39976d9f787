// What became of the forces of a step that were added up in integers.
#include <cmath>

#include "api/records/evaluation.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"

namespace weft {

namespace {

/// The vertex that is stored at an element of the device.
uint32_t vertex_at(const api::ClothRecord& cloth, int element) {
  const auto storage = static_cast<uint32_t>(element - cloth.first());
  return cloth.cooked().is_grid ? storage : cloth.cooked().caller_of[storage];
}

}  // namespace

inline namespace v0 {

Status World::Impl::find_overflow(api::Overflow& out) {
  api::ForceOverflow found;
  Status status = arena->force_overflow(found);
  if (status != Status::ok || !found.happened) return status;
  const api::ClothRecord* cloth = nullptr;
  for (const api::ClothRecord* c : built->cloths) {
    if (c->first() <= found.a) cloth = c;
  }
  const uint32_t a = vertex_at(*cloth, found.a), b = vertex_at(*cloth, found.b);
  double force = api::fixed_range(*cloth).limit;
  try {
    Vector<double3> x;
    status = arena->read(*cloth, api::StateArray::position, x);
    if (status != Status::ok) return status;
    force = found.stiffness * (api::length(api::minus(x[b], x[a])) - found.rest);
  } catch (const std::bad_alloc&) {  // it is lost all the same: of the force, the least is known
  }
  out.cloth = cloth->id;
  out.vertex = a;
  out.substep = found.substep;
  out.text = text(
      "vertex %u of cloth %u feels %.6g N of its spring to vertex %u (fixed64 counts up to %.6g N "
      "in "
      "this cloth) use accumulate native, or look for extreme inputs",
      a, cloth->id.index, force, b, api::fixed_range(*cloth).limit);
  return Status::diverged;
}

Status World::Impl::report_overflow() {
  api::Overflow found;
  const Status status = find_overflow(found);
  if (status != Status::diverged) return status;
  lost = true;
  const double when = time - flight.dt + found.substep * flight.dt / flight.substeps;
  events.push_back({EventType::force_overflow, found.cloth, found.vertex, when, nullptr},
                   found.text);
  return context->fail(status, found.text);
}

}  // namespace v0
}  // namespace weft
