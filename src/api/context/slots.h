// Ids of the objects of a world: a slot and a number that no object of this slot, in any world of
// the process, has had or will have. So an id never names two objects.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/memory_host.h"
#include "base/message_host.h"

namespace weft::api {

/// Hands out the numbers, each slot's once: 2^32 - 1 for all slots that are alike in their last 16
/// bits, 2^48 in all.
class IdNumbers {
 public:
  /// `first`: the number before the first that is given.
  explicit constexpr IdNumbers(uint32_t first = 0) noexcept : first_(first) {}

  /// 0: this slot has had all of them.
  uint32_t next(uint32_t slot) noexcept {
    std::atomic<uint32_t>& given = given_[slot % slots];
    uint32_t last = given.load(std::memory_order_relaxed);
    do {
      if (last == ~0u - first_) return 0;
    } while (!given.compare_exchange_weak(last, last + 1, std::memory_order_relaxed));
    return first_ + last + 1;
  }

  static constexpr uint32_t slots = 1u << 16;

 private:
  uint32_t first_;
  std::atomic<uint32_t> given_[slots] = {};
};

/// Those of the process.
inline IdNumbers id_numbers;

template <class IdType>
class Slots {
 public:
  explicit Slots(IdNumbers& numbers = id_numbers) : numbers_(numbers) {}

  /// Room for `count` more ids and their records, so that taking them cannot fail for want of
  /// memory. Throws std::bad_alloc.
  template <class Records>
  void make_room(Records& records, size_t count) {
    const size_t wanted = records.size() + count;
    if (wanted > records.capacity()) records.reserve(wanted + wanted / 2 + 8);
    free_.reserve(records.capacity());
  }
  /// A free slot of `records`, which grows by one when there is none. Throws std::bad_alloc, and
  /// InvalidInput where the ids are used up.
  template <class Records>
  IdType take(Records& records) {
    for (uint32_t tried = 0; tried <= IdNumbers::slots; ++tried) {
      if (free_.empty()) {
        make_room(records, 1);  // and giving back cannot fail
        records.emplace_back();
        free_.push_back(static_cast<uint32_t>(records.size() - 1));
      }
      const uint32_t slot = free_.back();
      free_.pop_back();
      if (const uint32_t number = numbers_.next(slot)) return {slot, number};
    }
    throw InvalidInput("no id is left (this process has given all of its ids) start it anew");
  }
  void give_back(uint32_t slot) noexcept { free_.push_back(slot); }

 private:
  IdNumbers& numbers_;
  Vector<uint32_t> free_;
};

}  // namespace weft::api
