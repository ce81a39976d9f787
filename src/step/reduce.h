// Fixed-tree reduction over an executor, into device memory.
#pragma once

#include "kernels/reduce.h"

namespace weft {

namespace WEFT_BACKEND_NS {

/// Sums value(i) for i < count; the sum is the last element of `scratch` that is used, whose
/// address is returned. To be called by every thread of the team.
template <class T, class Team, class Value>
T* reduce(const Team& team, const Value& value, int count, T* scratch) {
  int leaves = (count + reduce_leaf - 1) / reduce_leaf;
  leaves = leaves > 0 ? leaves : 1;
  team.for_each_block(leaves, SumLeaves<T, Value>{value, count, scratch});
  team.meet();
  while (leaves > 1) {
    const int next = (leaves + reduce_leaf - 1) / reduce_leaf;
    team.for_each_block(
        next, SumLeaves<T, ElementOf<T>>{ElementOf<T>{scratch}, leaves, scratch + leaves});
    team.meet();
    scratch += leaves;
    leaves = next;
  }
  return scratch;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
