// std::stable_sort whose room is host memory of the library (base/memory_host.h). Host code only.
#pragma once

#include <algorithm>
#include <iterator>

#include "base/memory_host.h"

namespace weft {

/// Sorts; elements that are alike keep their order. Throws std::bad_alloc, with all as it was.
template <class Iterator, class Less>
void stable_sort(Iterator first, Iterator last, Less less) {
  const auto count = last - first;
  if (count < 2 || std::is_sorted(first, last, less)) return;
  constexpr decltype(last - first) run = 16;
  using Value = typename std::iterator_traits<Iterator>::value_type;
  Vector<Value> room(static_cast<size_t>(count));
  for (auto begin = count - count; begin < count; begin += run) {
    const auto end = std::min(count, begin + run);
    for (auto i = begin + 1; i < end; ++i) {
      const Iterator at = std::upper_bound(first + begin, first + i, first[i], less);
      std::rotate(at, first + i, first + i + 1);
    }
  }
  for (auto width = run; width < count; width *= 2) {
    for (auto begin = count - count; begin < count; begin += 2 * width) {
      const auto middle = std::min(count, begin + width), end = std::min(count, middle + width);
      std::merge(first + begin, first + middle, first + middle, first + end, room.begin() + begin,
                 less);
    }
    std::copy(room.begin(), room.end(), first);
  }
}

}  // namespace weft
