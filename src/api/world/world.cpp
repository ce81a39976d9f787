#include <algorithm>
#include <cmath>

#include "api/arena/parts.h"
#include "api/world/call_guard.h"
#include "api/records/evaluation.h"
#include "api/records/projection.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"
#include "scene/check.h"

namespace weft {

namespace api {

static void check_projection(const WorldDesc& desc) {
  if (desc.integrator == Integrator::xpbd) {
    if (desc.form == Form::position) {
      throw InvalidInput("form is position (xpbd keeps displacements) give summed");
    }
    if (desc.evaluation == Evaluation::scatter) {
      throw InvalidInput(
          "evaluation is scatter (the springs of xpbd are constraints, and no forces to add up) "
          "give automatic");
    }
  }
  if (desc.ladder[0] == automatic_ladder) return;
  for (size_t k = 0; k < std::size(desc.ladder) && desc.ladder[k] != 0; ++k) {
    const int stride = desc.ladder[k], before = k > 0 ? desc.ladder[k - 1] : 65;
    if (stride >= 2 && stride < before) continue;
    throw InvalidInput(
        text("ladder[%zu] is %d (strides are 2 to 64, largest first) give descending strides, or "
             "automatic_ladder",
             k, stride));
  }
}

void check_world(const WorldDesc& desc) {
  scene::check_finite(desc.gravity.x, "gravity.x");
  scene::check_finite(desc.gravity.y, "gravity.y");
  scene::check_finite(desc.gravity.z, "gravity.z");
  scene::check_choice(int(desc.precision), 2, "precision", "float32, float64");
  scene::check_choice(int(desc.form), 2, "form", "summed, position");
  scene::check_choice(int(desc.start), 2, "start", "taylor, lagged");
  scene::check_choice(int(desc.integrator), 2, "integrator", "verlet, xpbd");
  check_projection(desc);
  scene::check_choice(int(desc.evaluation), 3, "evaluation", "automatic, gather, scatter");
  scene::check_choice(int(desc.accumulate), 7, "accumulate",
                      "native, atomic, fixed64, float16, float24, float24_all, fixed8");
  if (desc.accumulate != Accumulate::native && desc.evaluation != Evaluation::scatter) {
    throw InvalidInput(
        text("accumulate is %s (a gather sums in registers) give native or set "
             "evaluation to scatter",
             to_string(desc.accumulate)));
  }
  if (desc.accumulate == Accumulate::atomic && desc.deterministic) {
    throw InvalidInput(
        "accumulate is atomic while deterministic is true (the order of atomic additions changes "
        "from run to run) set deterministic to false or give fixed64");
  }
  if (!std::isfinite(desc.fixed8_range) || !(desc.fixed8_range > 0)) {
    throw InvalidInput(text("fixed8_range is %g (full scale is above 0) give largest spring forces",
                            desc.fixed8_range));
  }
  if (!std::isfinite(desc.fixed_dt) || !(desc.fixed_dt > 0)) {
    throw InvalidInput(
        text("fixed_dt is %g (it is the step of advance) give seconds above 0", desc.fixed_dt));
  }
  if (desc.max_steps_per_advance == 0) {
    throw InvalidInput(
        "max_steps_per_advance is 0 (time would never pass) give the most steps of a frame");
  }
  if (desc.max_substeps > 0 && desc.substeps > desc.max_substeps) {
    throw InvalidInput(
        text("substeps is %u (max_substeps, %u, is the most of a step) give at most that many, or "
             "raise max_substeps",
             desc.substeps, desc.max_substeps));
  }
  if (!(desc.safety > 0) || desc.safety > 1) {
    throw InvalidInput(
        text("safety is %g (a step is safe at a fraction of the bound) give a value in "
             "(0, 1]",
             desc.safety));
  }
}

}  // namespace api

inline namespace v0 {

World::Impl::Impl(std::shared_ptr<api::ContextState> owner, const WorldDesc& world_desc)
    : context(std::move(owner)),
      desc(world_desc),
      arena(api::make_arena(desc.precision, *context)) {
  events.make_room(16);
  publish();
}

api::ClothRecord* World::Impl::find(ClothId id) noexcept {
  if (!id || id.index >= cloths.size() || !cloths[id.index]) return nullptr;
  return cloths[id.index]->id == id ? cloths[id.index].get() : nullptr;
}

api::ColliderRecord* World::Impl::find(ColliderId id) noexcept {
  if (!id || id.index >= colliders.size() || colliders[id.index].id != id) return nullptr;
  return &colliders[id.index];
}

Status World::Impl::stale(const char* what, uint32_t index) noexcept {
  return context->fail(
      Status::invalid_handle,
      text("%s id %u names nothing (null, destroyed, or of another world) use the id "
           "that its creation returned",
           what, index));
}

World::World(World&& other) noexcept : impl_(other.impl_) { other.impl_ = nullptr; }
World& World::operator=(World&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}
World::~World() {
  if (!impl_) return;
  impl_->wait_for_flight();
  const std::shared_ptr<api::ContextState> keep = impl_->context;  // its memory
  delete impl_;
}

Result<ClothId> World::create_cloth(const ClothDesc& cloth_desc) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  ClothId id;
  const Status status = api::guarded(*impl_->context, [&] {
    auto record = std::make_unique<api::ClothRecord>(&impl_->context->memory);
    fill_record(cloth_desc, *record);
    start_motions(*record, impl_->time);
    impl_->start_bounds_of(*record);
    choose_evaluation(impl_->desc, impl_->context->backend->info(), *record);
    choose_colours(impl_->desc, *record);
    const Vector<scene::CookedDiagnostic> remarks = api::remarks_on(*record);
    if (impl_->order.size() == impl_->order.capacity()) {
      impl_->order.reserve(2 * impl_->order.size() + 8);
    }
    impl_->graves.reserve(impl_->order.capacity());  // what destroys may not need memory
    impl_->told.make_room(impl_->cloths.size() + 1);
    id = impl_->cloth_ids.take(impl_->cloths);
    record->id = id;
    impl_->told.add(id, record->bounds, record->cooked().vertices, record->cooked().springs);
    if (impl_->wind) impl_->say_if_windless(*record);
    for (const scene::CookedDiagnostic& d : remarks) {
      impl_->context->say(d.severity, text("cloth %u: %s", id.index, d.text.c_str()));
    }
    impl_->cloths[id.index] = std::move(record);
    impl_->order.push_back(id);
    impl_->dirty = true;
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return id;
}

/// The others' state must come to the host while the arena still matches its records. Where there
/// is no memory for it, it stays there, and the record with it.
Status World::Impl::bury(uint32_t slot) {
  if (!built) {
    cloths[slot].reset();
    return Status::ok;
  }
  cloths[slot]->buried = true;
  Status status = Status::ok;
  try {
    if (!order.empty()) status = arena->save(*built);
  } catch (const std::bad_alloc&) {
    graves.push_back(std::move(cloths[slot]));
    return Status::ok;
  }
  graves.clear();
  cloths[slot].reset();
  built.reset();
  return status;
}

Status World::destroy_cloth(ClothId id) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  if (!impl_->find(id)) return impl_->stale("cloth", id.index);
  return api::guarded(*impl_->context, [&] {
    impl_->dirty = true;
    impl_->order.erase(std::find(impl_->order.begin(), impl_->order.end(), id));
    impl_->wake_neighbours(*impl_->cloths[id.index], 0);
    if (const Status status = impl_->bury(id.index); status != Status::ok) return status;
    impl_->told.remove(id);
    impl_->cloth_ids.give_back(id.index);
    for (api::OutputRecord& output : impl_->outputs) {
      if (!output.id || output.cloth != id) continue;
      impl_->output_ids.give_back(output.id.index);
      output = {};
    }
    return Status::ok;
  });
}

bool World::valid(ClothId id) const noexcept { return impl_ && impl_->told.find(id); }

ColliderId World::Impl::add(api::ColliderRecord record) {
  record.since = time;
  record.id = collider_ids.take(colliders);
  wake_touched(record, 0);
  colliders[record.id.index] = record;
  dirty = true;
  return record.id;
}

void World::Impl::remove(api::ColliderRecord& collider) {
  wake_touched(collider, 0);
  const uint32_t slot = collider.id.index;
  collider = {};
  collider_ids.give_back(slot);
  dirty = true;
}

template <class Desc>
static Result<ColliderId> add_collider(World::Impl* impl, const Desc& desc,
                                       const char* call = __builtin_FUNCTION()) {
  const api::CallGuard guard(impl, api::CallGuard::During::rest, call);
  if (!guard) return guard.status();
  ColliderId id;
  const Status status = api::guarded(*impl->context, [&] {
    id = impl->add(api::record_of(desc));
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return id;
}

Result<ColliderId> World::create_sphere(const SphereDesc& d) noexcept {
  return add_collider(impl_, d);
}
Result<ColliderId> World::create_plane(const PlaneDesc& d) noexcept {
  return add_collider(impl_, d);
}
Result<ColliderId> World::create_capsule(const CapsuleDesc& d) noexcept {
  return add_collider(impl_, d);
}
Result<ColliderId> World::create_cylinder(const CylinderDesc& d) noexcept {
  return add_collider(impl_, d);
}
Result<ColliderId> World::create_box(const BoxDesc& d) noexcept { return add_collider(impl_, d); }

Result<ColliderId> World::create_mesh(const MeshColliderDesc& d) noexcept {
  return add_collider(impl_, d);
}

Status World::destroy_collider(ColliderId id) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  api::ColliderRecord* collider = impl_->find(id);
  if (!collider) return impl_->stale("collider", id.index);
  return api::guarded(*impl_->context, [&] {
    impl_->remove(*collider);
    return Status::ok;
  });
}

/// Pairs of a cloth that self-collision leaves out.
static void remark_on_excluded(const api::ClothRecord& cloth, const SelfCollisionDesc& desc,
                               Vector<scene::CookedDiagnostic>& out) {
  const uint64_t pairs = excluded_pairs(cloth, desc);
  if (pairs == 0) return;
  out.push_back({Severity::info, 0,
                 text("%llu pairs of vertices are nearer to each other at rest than the collision "
                      "distance, %g m (springs and contact would fight) they never touch, unless "
                      "the distance is smaller",
                      static_cast<unsigned long long>(pairs), collision_distance_of(cloth, desc))});
}

/// Every vertex must exist; `pinned`: each must have a pin.
static void check_vertices(const api::ClothRecord& cloth, View<uint32_t> vertices, bool pinned) {
  scene::check_view(vertices, "vertices");
  for (uint32_t i = 0; i < vertices.count; ++i) {
    if (vertices[i] >= cloth.cooked().vertices) {
      throw InvalidInput(
          text("vertices[%u] is %u (the cloth has %u vertices) give an index below that", i,
               vertices[i], cloth.cooked().vertices));
    }
    if (pinned && !cloth.pin_of(vertices[i])) {
      throw InvalidInput(
          text("vertices[%u]: vertex %u is not pinned (only a pin can be released) leave "
               "it out",
               i, vertices[i]));
    }
  }
}

Status World::move_pins(ClothId id, View<uint32_t> vertices, PointView targets) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  return api::guarded(*impl_->context, [&] {
    check_vertices(*cloth, vertices, false);
    scene::check_positions(targets, "targets");
    if (targets.count != vertices.count) {
      throw InvalidInput(
          text("targets has %u elements (vertices has %u) give one target per vertex",
               targets.count, vertices.count));
    }
    return impl_->lead_pins(*cloth, vertices, targets);
  });
}

Status World::set_skinned_targets(ClothId id, PointView targets) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  const api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  return api::guarded(*impl_->context, [&] {
    if (targets.count != cloth->cooked().vertices) {
      throw InvalidInput(
          text("targets has %u elements (the cloth has %u vertices) give one per vertex",
               targets.count, cloth->cooked().vertices));
    }
    scene::check_positions(targets, "targets");
    std::pmr::vector<uint32_t> vertices(&impl_->context->memory);
    std::pmr::vector<double3> places(&impl_->context->memory);
    for (const api::PinRecord& pin : cloth->pins) {
      vertices.push_back(pin.vertex);
      places.push_back(targets[pin.vertex]);
    }
    return move_pins(id, vertices, View<double3>(places));
  });
}

Status World::release_pins(ClothId id, View<uint32_t> vertices) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  return api::guarded(*impl_->context, [&] {
    check_vertices(*cloth, vertices, true);
    if (vertices.count == 0) return Status::ok;
    std::pmr::vector<uint32_t> sorted(&impl_->context->memory);
    sorted.reserve(vertices.count);
    for (uint32_t i = 0; i < vertices.count; ++i) sorted.push_back(vertices[i]);
    std::sort(sorted.begin(), sorted.end());
    api::wake(*cloth);
    const auto released = [&](const api::PinRecord& pin) {
      return std::binary_search(sorted.begin(), sorted.end(), pin.vertex);
    };
    cloth->pins.erase(std::remove_if(cloth->pins.begin(), cloth->pins.end(), released),
                      cloth->pins.end());
    cloth->repinned();
    impl_->dirty = true;
    return Status::ok;
  });
}

Result<View<Diagnostic>> World::diagnostics(ClothId id) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  View<Diagnostic> told;
  const Status status = api::guarded(*impl_->context, [&] {
    cloth->remarks = api::remarks_on(*cloth);
    if (impl_->self_collision) remark_on_excluded(*cloth, *impl_->self_collision, cloth->remarks);
    cloth->told_remarks.clear();
    for (const scene::CookedDiagnostic& d : cloth->remarks) {
      cloth->told_remarks.push_back({d.severity, d.element, d.text.c_str()});
    }
    told = {cloth->told_remarks.data(), cloth->told_remarks.size()};
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return told;
}

}  // namespace v0
}  // namespace weft
