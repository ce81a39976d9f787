// Hands messages to the caller's log. What is said again and again is counted and told rarely: a
// frame that goes wrong goes wrong sixty times a second.
#pragma once

#include <cstdint>
#include <mutex>

#include "base/message_host.h"
#include "weft/core.hpp"

namespace weft::api {

class Teller {
 public:
  /// The first eight times as it is, and then whenever its count has doubled, with the count.
  void tell(const Log&, Severity, const Text&) noexcept;

 private:
  struct Said {
    uint64_t hash = 0, count = 0, when = 0;
  };
  uint64_t count_of(const Text&) noexcept;

  std::mutex mutex_;
  Said said_[16];  ///< of late; what was said longest ago makes room
  uint64_t now_ = 0;
};

}  // namespace weft::api
