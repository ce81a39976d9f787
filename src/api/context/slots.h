// Ids of the objects of a world: a slot and a generation, whose upper half is the world's number. A
// slot whose generations are used up is retired: an id never names two objects.
#pragma once

#include <cstdint>
#include <vector>

namespace weft::api {

template <class IdType>
class Slots {
 public:
  explicit Slots(uint32_t world) : first_(world << 16) {}

  /// A free slot of `records`, which grows by one when there is none. Throws std::bad_alloc.
  template <class Records>
  IdType take(Records& records) {
    if (free_.empty()) {
      if (generations_.size() == generations_.capacity()) {
        const size_t room = 2 * generations_.size() + 8;
        generations_.reserve(room);
        free_.reserve(room);  // giving back cannot fail
      }
      records.emplace_back();
      generations_.push_back(first_);
      free_.push_back(static_cast<uint32_t>(records.size() - 1));
    }
    const uint32_t slot = free_.back();
    free_.pop_back();
    return {slot, ++generations_[slot]};
  }
  void give_back(uint32_t slot) noexcept {
    if ((generations_[slot] & 0xffff) != 0xffff) free_.push_back(slot);
  }

 private:
  uint32_t first_;
  std::vector<uint32_t> generations_, free_;
};

}  // namespace weft::api
