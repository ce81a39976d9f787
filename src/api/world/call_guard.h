// The door of a world: one thread at a time, and nobody while a step is in flight. Calls of a world
// that are made of other calls go through it again and again.
#pragma once

#include "api/world/state.h"

namespace weft::api {

class CallGuard {
 public:
  enum class During : uint8_t { rest, flight };

  /// `during`: whether a step must be in flight, or must not. `call` names what is asked for in
  /// messages.
  explicit CallGuard(World::Impl* world, During during = During::rest,
                     const char* call = __builtin_FUNCTION()) noexcept;
  /// Of a call about a cloth.
  CallGuard(World::Impl* world, ClothId cloth, const char* call = __builtin_FUNCTION()) noexcept
      : CallGuard(world, During::rest, call) {
    if (held_) asked_of_thread.cloth = cloth;
  }
  ~CallGuard();
  CallGuard(const CallGuard&) = delete;
  CallGuard& operator=(const CallGuard&) = delete;

  explicit operator bool() const { return status_ == Status::ok; }
  Status status() const { return status_; }

 private:
  World::Impl* held_ = nullptr;  ///< null: refused, or the thread was inside already
  Asked before_;
  Status status_ = Status::ok;
};

}  // namespace weft::api
