// Cloth that meets itself and other cloths.
#include "api/world/call_guard.h"
#include "api/world/state.h"
#include "scene/check.h"

namespace weft {
inline namespace v0 {

Status World::set_self_collision(const SelfCollisionDesc& desc) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  return api::guarded(*impl_->context, [&] {
    scene::check_positive(desc.distance, "self_collision.distance");
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

Result<ContactCounts> World::contacts() noexcept { return ContactCounts{}; }

Result<View<NearPair>> World::near_pairs(bool with_excluded) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  if (!impl_->self_collision) {
    return impl_->context->fail(Status::invalid_argument,
                                "the world has no self-collision (it searches no pairs) call "
                                "set_self_collision first");
  }
  const Status ended = api::guarded(*impl_->context, [&] {
    impl_->pairs.clear();
    const Status status = impl_->ensure_readable();
    if (status != Status::ok || !impl_->built) return status;
    return impl_->arena->near_pairs(*impl_->built, with_excluded, impl_->context->workers(),
                                    impl_->pairs);
  });
  if (ended != Status::ok) return ended;
  return View<NearPair>{impl_->pairs.data(), static_cast<uint32_t>(impl_->pairs.size())};
}

}  // namespace v0
}  // namespace weft
