#include "api/world/call_guard.h"

namespace weft::api {

/// The address of a thread's own variable is its name.
static const void* this_thread() noexcept {
  static thread_local const char name = 0;
  return &name;
}

CallGuard::CallGuard(World::Impl* world, During during, const char* call) noexcept
    : before_(asked_of_thread) {
  if (!world) {
    status_ = Status::invalid_handle;
    return;
  }
  const void* inside = nullptr;
  if (world->inside.compare_exchange_strong(inside, this_thread())) {
    held_ = world;
    asked_of_thread = {call, {}};
    world->inside_for.store(call, std::memory_order_relaxed);
  } else if (inside != this_thread()) {
    status_ = world->context->fail(
        Status::wrong_thread,
        text("%s while another thread is inside %s (a world serves one thread at a time) wait for "
             "it, or give each thread a world of its own",
             call, world->inside_for.load(std::memory_order_relaxed)));
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
  if (!held_) return;
  asked_of_thread = before_;
  held_->publish();
  held_->inside.store(nullptr);
}

}  // namespace weft::api
