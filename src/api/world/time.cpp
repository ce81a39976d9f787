// Time as engines pass it: frames of uneven length in steps of an even one, and steps that run
// while the engine does something else.
#include <cmath>
#include <thread>

#include "api/world/call_guard.h"
#include "api/world/state.h"

namespace weft {
inline namespace v0 {

Result<Advance> World::advance(double frame_dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  const double fixed = impl_->desc.fixed_dt;
  Advance made;
  const Status status = api::guarded(*impl_->context, [&] {
    if (!std::isfinite(frame_dt) || frame_dt < 0) {
      throw InvalidInput(
          text("a frame of %g s (time runs forward) give a finite frame_dt >= 0", frame_dt));
    }
    impl_->time_owed += frame_dt;
    // A frame of exactly n steps may come out a rounding short of n.
    const double due = std::floor(impl_->time_owed / fixed + 1e-9);
    const double most = impl_->desc.max_steps_per_advance;
    while (made.steps < due && made.steps < most) {
      if (const Status stepped = step(fixed); stepped != Status::ok) {
        impl_->time_owed = std::fmax(0.0, impl_->time_owed - made.steps * fixed);
        return stepped;
      }
      ++made.steps;
    }
    impl_->time_owed = std::fmax(0.0, impl_->time_owed - due * fixed);
    if (due > most) {
      impl_->time_dropped += (due - most) * fixed;
      impl_->events.push_back({EventType::time_dropped,
                               {},
                               0,
                               impl_->time,
                               "advance took fewer steps than the frame was long"});
    }
    made.alpha = std::fmin(impl_->time_owed / fixed, 1 - 1e-9);
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return made;
}

static void fly_and_tell(void* world) {
  auto* impl = static_cast<World::Impl*>(world);
  impl->fly();
  impl->flight.done.store(true, std::memory_order_release);
  impl->flight.done.notify_one();
  impl->flight.left.store(true, std::memory_order_release);
}

void World::Impl::start_flight() {
  flight.done.store(false, std::memory_order_relaxed);
  flight.left.store(false, std::memory_order_relaxed);
  const Jobs& jobs = context->jobs;
  if (jobs.launch) return jobs.launch(jobs.user, fly_and_tell, this, "weft step");
  if (jobs.parallel_for) return fly_and_tell(this);
  if (!runner.start(fly_and_tell, this)) fly_and_tell(this);  // no thread to be had: now, then
}

void World::Impl::wait_for_flight() noexcept {
  flight.done.wait(false, std::memory_order_acquire);
  while (!flight.left.load(std::memory_order_acquire)) std::this_thread::yield();
}

Status World::begin_step(double dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  Result<uint32_t> n = substeps(dt);
  if (!n) return n.status();
  return api::guarded(*impl_->context, [&] {
    impl_->flight.dt = 0;
    if (dt > 0) {
      if (!impl_->context->jobs.parallel_for) impl_->runner.make();  // while nothing has begun
      if (const Status status = impl_->begin(dt, *n); status != Status::ok) return status;
      impl_->start_flight();
    }
    impl_->flight.active = true;
    return Status::ok;
  });
}

bool World::step_done() const noexcept {
  return !impl_ || impl_->flight.done.load(std::memory_order_acquire);
}

Status World::end_step() noexcept {
  const api::CallGuard guard(impl_, api::CallGuard::During::flight);
  if (!guard) return guard.status();
  impl_->wait_for_flight();
  impl_->flight.active = false;
  if (impl_->flight.dt == 0) return Status::ok;
  impl_->step_seconds += impl_->flight.seconds;
  return api::guarded(*impl_->context, [&] { return impl_->land(); });
}

}  // namespace v0
}  // namespace weft
