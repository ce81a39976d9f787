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
  /// The first eight times as it is, and then whenever its count has doubled, with the count. Texts
  /// that differ by their numbers alone are told 128 times, and then as rarely.
  void tell(const Log&, Severity, const Text&) noexcept;

 private:
  struct Said {
    uint64_t hash = 0, count = 0, when = 0;
  };
  struct Memory {
    Said said[16];  ///< of late; what was said longest ago makes room
    uint64_t now = 0;

    uint64_t count(uint64_t hash) noexcept;
  };

  std::mutex mutex_;
  Memory texts_, forms_;
};

}  // namespace weft::api
