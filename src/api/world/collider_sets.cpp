// Colliders that a character sends whole every frame.
#include "api/world/call_guard.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"
#include "scene/check.h"

namespace weft {
inline namespace v0 {

namespace {

/// A view of a set as records, in the order of the members; throws InvalidInput.
struct Described {
  struct Name {
    const char* view;
    uint32_t index;
  };
  Vector<api::ColliderRecord> records;
  Vector<Name> names;
};

template <class Desc>
void describe(View<Desc> views, const char* name, Described& out) {
  scene::check_view(views, name);
  for (uint32_t i = 0; i < views.count; ++i) {
    out.names.push_back({name, i});
    try {
      out.records.push_back(api::record_of(views[i]));
    } catch (const InvalidInput& problem) {
      throw InvalidInput(text("%s[%u]: %s", name, i, problem.what()));
    }
  }
}

Described described(const ColliderSetDesc& desc, size_t expected = 0) {
  Described all;
  all.records.reserve(expected);
  all.names.reserve(expected);
  describe(desc.spheres, "spheres", all);
  describe(desc.planes, "planes", all);
  describe(desc.capsules, "capsules", all);
  describe(desc.cylinders, "cylinders", all);
  describe(desc.boxes, "boxes", all);
  return all;
}

}  // namespace

api::ColliderSetRecord* World::Impl::find(ColliderSetId id) noexcept {
  if (!id || id.index >= collider_sets.size() || collider_sets[id.index].id != id) return nullptr;
  return &collider_sets[id.index];
}

Result<ColliderSetId> World::create_collider_set(const ColliderSetDesc& desc) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  ColliderSetId id;
  const Status status = api::guarded(*impl_->context, [&] {
    const Described all = described(desc);
    api::ColliderSetRecord set;
    set.members.reserve(all.records.size());
    impl_->collider_set_ids.make_room(impl_->collider_sets, 1);
    impl_->collider_ids.make_room(impl_->colliders, all.records.size());
    id = impl_->collider_set_ids.take(impl_->collider_sets);
    for (const api::ColliderRecord& record : all.records) {
      set.members.push_back(impl_->add(record));
    }
    set.id = id;
    impl_->collider_sets[id.index] = std::move(set);
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return id;
}

void World::Impl::stretch(api::ColliderRecord& c, const api::ColliderRecord& other) {
  if (same_sizes(c, other)) return;
  probed = false;
  wake_touched(c, 0);
  take_sizes(c, other);
  wake_touched(c, 0);
}

Status World::move_collider_set(ColliderSetId id, const ColliderSetDesc& desc, Move how) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  const api::ColliderSetRecord* set = impl_->find(id);
  if (!set) return impl_->stale("collider set", id.index);
  return api::guarded(*impl_->context, [&] {
    scene::check_choice(int(how), 2, "how", "simulate, teleport");
    const Described all = described(desc, set->members.size());
    Vector<std::pair<api::ColliderRecord*, const api::ColliderRecord*>> moves;
    for (size_t i = 0; i < all.records.size() && i < set->members.size(); ++i) {
      api::ColliderRecord* member = impl_->find(set->members[i]);
      if (!member || member->shape != all.records[i].shape) break;
      const Described::Name& name = all.names[i];
      if (!desc.may_stretch) check_sizes(*member, all.records[i], name.view, name.index);
      moves.emplace_back(member, &all.records[i]);
    }
    if (moves.size() != all.records.size() || moves.size() != set->members.size()) {
      throw InvalidInput(
          text("the set has %zu colliders, the description %zu (or other shapes, or one was "
               "destroyed alone) give those it was created with, or create the set anew",
               set->members.size(), all.records.size()));
    }
    for (const auto& [member, other] : moves) {
      if (desc.may_stretch) impl_->stretch(*member, *other);
      const api::Placed from = placed_at(*member, impl_->time);
      impl_->move(*member, api::motion_to(*member, from, *other), how);
    }
    return Status::ok;
  });
}

Status World::destroy_collider_set(ColliderSetId id) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  api::ColliderSetRecord* set = impl_->find(id);
  if (!set) return impl_->stale("collider set", id.index);
  return api::guarded(*impl_->context, [&] {
    for (const ColliderId member : set->members) {
      if (api::ColliderRecord* collider = impl_->find(member)) impl_->remove(*collider);
    }
    *set = {};
    impl_->collider_set_ids.give_back(id.index);
    return Status::ok;
  });
}

}  // namespace v0
}  // namespace weft
