// What a reader may take, so that a small file cannot ask for all of a machine.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace weft::io {

/// Counts the bytes of growing arrays, the copy that growing makes included.
class MemoryLimit {
 public:
  /// Bytes in all, of which some are taken.
  MemoryLimit(uint64_t most, uint64_t taken) : left_(most > taken ? most - taken : 0) {}

  /// Room for `more` values behind those there are. False, and nothing changes, when they do not
  /// fit.
  template <class Array>
  bool make_room(Array& array, uint64_t more) {
    if (array.capacity() - array.size() >= more) return true;
    constexpr uint64_t each = sizeof(typename Array::value_type);
    const uint64_t old = array.capacity() * each;
    if (more > left_ / each) return false;
    const uint64_t least = (array.size() + more) * each;
    const uint64_t wanted = std::max(least, std::min(2 * old, left_));
    if (wanted > left_) return false;
    array.reserve(size_t(wanted / each));
    left_ = left_ - wanted + old;
    return true;
  }

 private:
  uint64_t left_;
};

}  // namespace weft::io
