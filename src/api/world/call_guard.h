// The door of a world: one thread at a time, and nobody while a step is in flight. Calls of a world
// that are made of other calls go through it again and again.
#pragma once

#include "api/world/state.h"

namespace weft::api {

class CallGuard {
 public:
  enum class During : uint8_t { rest, flight };

  /// `during`: whether a step must be in flight, or must not.
  explicit CallGuard(World::Impl* world, During during = During::rest) noexcept;
  ~CallGuard();
  CallGuard(const CallGuard&) = delete;
  CallGuard& operator=(const CallGuard&) = delete;

  explicit operator bool() const { return status_ == Status::ok; }
  Status status() const { return status_; }

 private:
  World::Impl* held_ = nullptr;  ///< null: refused, or the thread was inside already
  Status status_ = Status::ok;
};

}  // namespace weft::api
