// Time as engines pass it: frames of uneven length in steps of an even one, and steps that run
// while the engine does something else.
#include <cmath>
#include <thread>

#include "api/world/call_guard.h"
#include "api/world/state.h"

namespace weft {
inline namespace v0 {

/// The steps that a frame takes, and where they end on its inputs' way, as a fraction of it.
struct FrameSteps {
  double steps, dropped, owed, owed_before, length;

  double way_at(double step, double fixed) const {
    const double at = (step * fixed - owed_before) / (length > 0 ? length : 1);
    return at < 1 - 1e-9 ? std::fmax(at, 0.0) : 1;
  }
};

static FrameSteps steps_of(double frame_dt, double owed_before, double fixed, double most) {
  const double owed = owed_before + frame_dt;
  // A frame of exactly n steps may come out a rounding short of n.
  const double due = std::floor(owed / fixed + 1e-9);
  if (due <= most) {
    return {due, 0, std::fmax(0.0, owed - due * fixed), owed_before, frame_dt};
  }
  const double left = std::fmod(owed, fixed);
  const double dropped = owed - left - most * fixed;
  return {most, dropped, left, owed_before, most * fixed + left - owed_before};
}

double World::Impl::drawn_time(double alpha) const {
  return desc.interpolate ? time - (1 - alpha) * frame_dt : time;
}

Result<Advance> World::advance(double frame_dt) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  const double fixed = impl_->desc.fixed_dt;
  Advance made;
  const Status status = api::guarded(*impl_->context, [&] {
    impl_->begin_events();
    if (!std::isfinite(frame_dt) || frame_dt < 0) {
      throw InvalidInput(
          text("a frame of %g s (time runs forward) give a finite frame_dt >= 0", frame_dt));
    }
    const FrameSteps frame =
        steps_of(frame_dt, impl_->time_owed, fixed, impl_->desc.max_steps_per_advance);
    impl_->time_owed = 0;  // nothing, where a step fails
    api::Stride stride;
    if (frame.steps > 0) {
      if (const Status bad = impl_->stride_of(fixed, stride); bad != Status::ok) return bad;
    }
    for (; made.steps < frame.steps; ++made.steps) {
      const Status stepped = impl_->run(stride, frame.way_at(made.steps + 1.0, fixed));
      if (stepped != Status::ok) return stepped;
    }
    if (frame_dt > 0) impl_->end_inputs();
    if (frame.dropped > 0) {
      impl_->drop_time(frame.dropped, "advance took fewer steps than the frame was long");
    }
    impl_->time_owed = frame.owed;
    made.alpha = std::fmin(frame.owed / fixed, 1 - 1e-9);
    made.time = impl_->drawn_time(made.alpha);
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
  return api::guarded(*impl_->context, [&] {
    impl_->begin_events();
    api::Stride stride;
    Status status = impl_->stride_of(dt, stride);
    if (status != Status::ok) return status;
    impl_->flight.dt = 0;
    if (dt > 0) {
      if (!impl_->context->jobs.parallel_for) impl_->runner.make();  // while nothing has begun
      if (status = impl_->begin(stride, 1); status != Status::ok) return status;
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
