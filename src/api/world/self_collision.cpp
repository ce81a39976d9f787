// Cloth that meets itself and other cloths.
#include "api/world/call_guard.h"
#include "api/world/state.h"
#include "scene/check.h"

namespace weft {
inline namespace v0 {

static void check_self_collision(const SelfCollisionDesc& d) {
  scene::check_choice(int(d.search), 2, "self_collision.search", "complete, staggered");
  scene::check_positive(d.distance, "self_collision.distance");
  api::check_collision_distance(d.distance, "self_collision.distance");
  scene::check_not_negative(d.friction, "self_collision.friction");
  scene::check_positive(d.cell, "self_collision.cell");
  scene::check_choice(int(d.shifts), 2, "self_collision.shifts", "corner, diagonal");
  scene::check_finite(d.skin, "self_collision.skin");
  const uint32_t grids = d.grids;
  const bool corners = grids == 1 || grids == 2 || grids == 4 || grids == 8;
  if (d.shifts == GridShifts::corner && !corners) {
    throw InvalidInput(
        text("self_collision.grids is %u (shifts of corner come as 1, 2, 4 or 8) give one of these",
             grids));
  }
  if (grids == 0 || grids > 64) {
    throw InvalidInput(
        text("self_collision.grids is %u (shifts of diagonal come as 1 to 64) give one of these",
             grids));
  }
}

static bool same_self_collision(const SelfCollisionDesc& a, const SelfCollisionDesc& b) {
  return a.search == b.search && a.distance == b.distance && a.friction == b.friction &&
         a.cell == b.cell && a.grids == b.grids && a.shifts == b.shifts && a.window == b.window &&
         a.skin == b.skin;
}

Status World::set_self_collision(const SelfCollisionDesc& desc) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  return api::guarded(*impl_->context, [&] {
    check_self_collision(desc);
    if (impl_->self_collision && same_self_collision(*impl_->self_collision, desc)) {
      return Status::ok;
    }
    impl_->self_collision = desc;
    impl_->dirty = true;
    impl_->forget_results();
    impl_->wake_all();
    return Status::ok;
  });
}

Status World::clear_self_collision() noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  if (!impl_->self_collision) return Status::ok;
  return api::guarded(*impl_->context, [&] {
    impl_->self_collision.reset();
    impl_->dirty = true;
    impl_->forget_results();
    impl_->wake_all();
    return Status::ok;
  });
}

Result<ContactCounts> World::contacts() noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  ContactCounts counts;
  const Status status = api::guarded(*impl_->context, [&] {
    if (!impl_->self_collision) return Status::ok;
    const Status found = impl_->find_pairs(false);
    if (found != Status::ok) return found;
    counts.touching = impl_->pairs.size();
    Vector<NearPair>().swap(impl_->pairs);
    for (const ClothId id : impl_->order) {
      counts.excluded += api::excluded_pairs(*impl_->find(id), *impl_->self_collision);
    }
    impl_->arena->list_counts(counts.lists, counts.listed);
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return counts;
}

Status World::Impl::find_pairs(bool with_excluded) {
  pairs.clear();
  const Status status = ensure_readable();
  if (status != Status::ok || !built) return status;
  return arena->near_pairs(*built, with_excluded, context->workers(), pairs);
}

Result<View<NearPair>> World::near_pairs(bool with_excluded) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  if (!impl_->self_collision) {
    return impl_->context->fail(Status::invalid_argument,
                                "the world has no self-collision (it searches no pairs) call "
                                "set_self_collision first");
  }
  const Status ended =
      api::guarded(*impl_->context, [&] { return impl_->find_pairs(with_excluded); });
  if (ended != Status::ok) return ended;
  return View<NearPair>{impl_->pairs.data(), impl_->pairs.size()};
}

}  // namespace v0
}  // namespace weft
