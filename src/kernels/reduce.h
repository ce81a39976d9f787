// Sums over a fixed tree: the same bits for any number of threads, on the CPU and on a GPU.
//
// A leaf is 1024 elements: lane l adds elements l, l + 32, ..., then lanes are added in halves
// 16, 8, 4, 2, 1. The sums of the leaves go through the same function until one is left.
#pragma once

#include "base/lanes.h"

namespace weft {
namespace WEFT_BACKEND_NS {

constexpr int reduce_leaf = 1024;

/// One level of the tree: block b writes the sum of leaf b of `value(i)`, i < count, to out[b].
template <class T, class Value>
struct SumLeaves {
  Value value;
  int count;
  T* out;

  template <int N>
  WEFT_HD void operator()(int leaf, int lane0, Lanes<N> lanes) const {
    T partial[N] = {};
    const int first = leaf * reduce_leaf;
    const int end = count - first < reduce_leaf ? count : first + reduce_leaf;
    int i = first;
    for (; i + block_size <= end; i += block_size) {
      lanes.each([&](int l) WEFT_LANE { partial[l] += value(i + lane0 + l); });
    }
    for (int l = 0; l < N; ++l) {
      if (i + lane0 + l < end) partial[l] += value(i + lane0 + l);
    }
    const T sum = sum_of_lanes(partial, lanes);
    if (lane0 == 0) out[leaf] = sum;
  }
};

/// Elements of an array, for SumLeaves.
template <class T>
struct ElementOf {
  const T* data;
  WEFT_HD T operator()(int i) const { return data[i]; }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
