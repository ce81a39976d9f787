#include "api/world/call_guard.h"

namespace weft::api {

/// The address of a thread's own variable is its name.
static const void* this_thread() noexcept {
  static thread_local const char name = 0;
  return &name;
}

CallGuard::CallGuard(World::Impl* world, During during) noexcept {
  if (!world) {
    status_ = Status::invalid_handle;
    return;
  }
  const void* inside = nullptr;
  if (world->inside.compare_exchange_strong(inside, this_thread())) {
    held_ = world;
  } else if (inside != this_thread()) {
    status_ = world->context->fail(Status::wrong_thread,
                                   "another thread is inside the world (a world serves one at a "
                                   "time) wait for it, or give each thread a world of its own");
    return;
  }
  if (during == During::rest && world->flight.active) {
    status_ = world->context->fail(
        Status::in_flight, "a step is in flight (begin_step was called) call end_step first");
  } else if (during == During::flight && !world->flight.active) {
    status_ = world->context->fail(Status::invalid_argument,
                                   "no step is in flight (nothing to end) call begin_step first");
  }
}

CallGuard::~CallGuard() {
  if (held_) held_->inside.store(nullptr);
}

}  // namespace weft::api
