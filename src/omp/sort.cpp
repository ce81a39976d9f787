#include "omp/sort.h"

#include <omp.h>
#include <string.h>
#include <thrust/execution_policy.h>
#include <thrust/scan.h>
#include <thrust/sort.h>

namespace weft {
namespace omp {

// Integers: the sum does not depend on the order in which threads add.
void exclusive_scan(const uint32_t* in, uint32_t* out, int count, bool alone) {
  if (alone) {
    thrust::exclusive_scan(thrust::seq, in, in + count, out, uint32_t(0));
  } else {
    thrust::exclusive_scan(thrust::device, in, in + count, out, uint32_t(0));
  }
}

void stable_sort_by_key(uint32_t* keys, uint32_t* values, int count, bool alone) {
  if (alone) {
    thrust::stable_sort_by_key(thrust::seq, keys, keys + count, values);
  } else {
    thrust::stable_sort_by_key(thrust::device, keys, keys + count, values);
  }
}

namespace {

constexpr int most_upper_bits = 12;
constexpr int most_digit_bits = 11;
constexpr int most_threads = 64;  // of stable_sort_few_bits: more have no memory to wait for

/// Bits of a key that choose its bucket: 256 buckets, or as many as leave room for the index of one
/// of 2^bits particles beside the others in a word.
int upper_bits(int bits) {
  const int wanted = 2 * bits - 32 > 8 ? 2 * bits - 32 : 8;
  const int most = wanted < most_upper_bits ? wanted : most_upper_bits;
  return bits < most ? bits : most;
}

int share_of(int count, int thread, int threads) {
  return static_cast<int>(int64_t(count) * thread / threads);
}

uint64_t pair_of(uint32_t key, uint32_t value) { return uint64_t(key) << 32 | value; }
uint32_t key_of(uint64_t pair) { return static_cast<uint32_t>(pair >> 32); }
uint32_t value_of(uint64_t pair) { return static_cast<uint32_t>(pair); }

/// A key's lower bits with an index, where both fit: half the memory to write and to read.
struct Narrow {
  uint32_t word;
  Narrow(uint32_t key, uint32_t index, int lower)
      : word(index << lower | (key & ((1u << lower) - 1))) {}
  uint32_t key(uint32_t mask) const { return word & mask; }
  uint32_t value(int lower) const { return word >> lower; }
};
struct Wide {
  uint64_t pair;
  Wide(uint32_t key, uint32_t value, int) : pair(pair_of(key, value)) {}
  uint32_t key(uint32_t mask) const { return key_of(pair) & mask; }
  uint32_t value(int) const { return value_of(pair); }
};
bool is_narrow(const CellSort& s) {
  return s.values == nullptr &&
         static_cast<uint64_t>(s.count) << (s.bits - upper_bits(s.bits)) <= uint64_t(1) << 32;
}

template <class Pair>
void deal(const CellSort& s, int begin, int end, uint32_t* next) {
  const int lower = s.bits - upper_bits(s.bits);
  const uint32_t *keys = s.keys, *values = s.values;
  auto* pairs = static_cast<Pair*>(s.room);
  // A sheet fills one bucket for many particles on end: its place is kept out of memory.
  uint32_t bucket = 0, place = next[0];
  for (int i = begin; i < end; ++i) {
    const uint32_t key = keys[i];
    const uint32_t value = values ? values[i] : static_cast<uint32_t>(i);
    if (key >> lower != bucket) {
      next[bucket] = place;
      bucket = key >> lower;
      place = next[bucket];
    }
    pairs[place++] = Pair(key, value, lower);
  }
}

/// Counts the cells of the bucket whose pairs are [begin, end), and puts each pair where it
/// belongs. Last pairs go first, into the last free place: what is left of a cell's end is its
/// start.
template <class Pair>
void place(const CellSort& s, uint32_t bucket, uint32_t begin, uint32_t end) {
  const int lower = s.bits - upper_bits(s.bits);
  const uint32_t cells = 1u << lower, mask = cells - 1;
  const auto* pairs = static_cast<const Pair*>(s.room);
  uint32_t *starts = s.starts + (static_cast<size_t>(bucket) << lower), *sorted = s.sorted;
  memset(starts, 0, cells * sizeof *starts);
  for (uint32_t i = begin; i < end; ++i) ++starts[pairs[i].key(mask)];
  uint32_t sum = begin;
  for (uint32_t c = 0; c < cells; ++c) starts[c] = sum += starts[c];
  for (uint32_t i = end; i-- > begin;) {
    const Pair pair = pairs[i];
    sorted[--starts[pair.key(mask)]] = pair.value(lower);
  }
}

void repeat_keys(const CellSort& s, uint32_t bucket, uint32_t end) {
  const int lower = s.bits - upper_bits(s.bits);
  const uint32_t first = bucket << lower, last = first + (1u << lower) - 1;
  for (uint32_t c = first; c <= last; ++c) {
    const uint32_t stop = c < last ? s.starts[c + 1] : end;
    for (uint32_t i = s.starts[c]; i < stop; ++i) s.sorted_keys[i] = c;
  }
}

/// Pairs as they are given, and in the room.
struct Apart {
  uint32_t *keys, *values;
  uint64_t get(int i) const { return pair_of(keys[i], values[i]); }
  void set(uint32_t i, uint64_t pair) const {
    keys[i] = key_of(pair);
    values[i] = value_of(pair);
  }
};
struct Together {
  uint64_t* pairs;
  uint64_t get(int i) const { return pairs[i]; }
  void set(uint32_t i, uint64_t pair) const { pairs[i] = pair; }
};

/// One digit of a key: `bits` from `shift` on.
struct Digit {
  int shift, bits;
  uint32_t of(uint64_t pair) const { return key_of(pair) >> shift & ((1u << bits) - 1); }
};

/// A counting sort by one digit; every thread of the region calls it. counts_of[t]: the counts of
/// thread t, on its own stack.
template <class From, class To>
void sort_by_digit(From from, To to, int count, Digit digit, int thread, int threads,
                   uint32_t* const* counts_of) {
  const int begin = share_of(count, thread, threads), end = share_of(count, thread + 1, threads);
  const uint32_t digits = 1u << digit.bits;
  uint32_t* mine = counts_of[thread];
  memset(mine, 0, digits * sizeof *mine);
  for (int i = begin; i < end; ++i) ++mine[digit.of(from.get(i))];
  uint32_t next[1 << most_digit_bits];
#pragma omp barrier
  uint32_t sum = 0;
  for (uint32_t d = 0; d < digits; ++d) {
    for (int t = 0; t < threads; ++t) {
      if (t == thread) next[d] = sum;
      sum += counts_of[t][d];
    }
  }
  for (int i = begin; i < end; ++i) {
    const uint64_t pair = from.get(i);
    to.set(next[digit.of(pair)]++, pair);
  }
#pragma omp barrier
}

}  // namespace

size_t cell_sort_counts(int bits, int threads) {
  return static_cast<size_t>(threads) << upper_bits(bits);
}

void count_cells(const CellSort& s, int thread, int threads) {
  const int upper = upper_bits(s.bits), lower = s.bits - upper;
  uint32_t* mine = s.counts + (static_cast<size_t>(thread) << upper);
  memset(mine, 0, sizeof *mine << upper);
  const int end = share_of(s.count, thread + 1, threads);
  // A sheet fills one bucket for many particles on end: two counters wait less for each other.
  uint32_t odd[1 << most_upper_bits];
  memset(odd, 0, sizeof *odd << upper);
  const uint32_t* keys = s.keys;
  int i = share_of(s.count, thread, threads);
  for (; i + 1 < end; i += 2) {
    ++mine[keys[i] >> lower];
    ++odd[keys[i + 1] >> lower];
  }
  if (i < end) ++mine[keys[i] >> lower];
  for (int b = 0; b < 1 << upper; ++b) mine[b] += odd[b];
}

void deal_cells(const CellSort& s, int thread, int threads) {
  const int upper = upper_bits(s.bits);
  uint32_t next[1 << most_upper_bits];
  uint32_t sum = 0;
  for (uint32_t b = 0; b < 1u << upper; ++b) {
    for (int t = 0; t < threads; ++t) {
      if (t == thread) next[b] = sum;
      sum += s.counts[(static_cast<size_t>(t) << upper) + b];
    }
  }
  const int begin = share_of(s.count, thread, threads);
  const int end = share_of(s.count, thread + 1, threads);
  if (is_narrow(s)) {
    deal<Narrow>(s, begin, end, next);
  } else {
    deal<Wide>(s, begin, end, next);
  }
}

// A bucket is the work of the thread in whose share of pairs and cells it begins.
void place_cells(const CellSort& s, int thread, int threads) {
  const int upper = upper_bits(s.bits), lower = s.bits - upper;
  const int64_t work = int64_t(s.count) + (int64_t(1) << s.bits);
  const int64_t from = work * thread / threads, to = work * (thread + 1) / threads;
  uint32_t begin = 0;
  for (uint32_t b = 0; b < 1u << upper; ++b) {
    uint32_t end = begin;
    for (int t = 0; t < threads; ++t) end += s.counts[(static_cast<size_t>(t) << upper) + b];
    const int64_t before = int64_t(begin) + (int64_t(b) << lower);
    if (before >= from && before < to) {
      if (is_narrow(s)) {
        place<Narrow>(s, b, begin, end);
      } else {
        place<Wide>(s, b, begin, end);
      }
      if (s.sorted_keys != nullptr) repeat_keys(s, b, end);
    }
    begin = end;
  }
  if (thread == 0) s.starts[size_t(1) << s.bits] = static_cast<uint32_t>(s.count);
}

void sort_cells(const CellSort& s, int threads) {
  if (threads <= 1) {
    count_cells(s, 0, 1);
    deal_cells(s, 0, 1);
    return place_cells(s, 0, 1);
  }
#pragma omp parallel num_threads(threads)
  {
    const int thread = omp_get_thread_num(), all = omp_get_num_threads();
    count_cells(s, thread, all);
#pragma omp barrier
    deal_cells(s, thread, all);
#pragma omp barrier
    place_cells(s, thread, all);
  }
}

// Digits from the lowest on, from the arrays into the room and back.
void stable_sort_few_bits(uint32_t* keys, uint32_t* values, uint64_t* pairs, int count, int bits,
                          int threads) {
  const int passes = bits <= 2 * most_digit_bits ? 2 : 4;
  const int wide = (bits + passes - 1) / passes;
  uint32_t* counts_of[most_threads];
#pragma omp parallel num_threads(threads < most_threads ? threads : most_threads) if (threads > 1)
  {
    const int thread = omp_get_thread_num(), all = omp_get_num_threads();
    uint32_t counts[1 << most_digit_bits];
    counts_of[thread] = counts;
    const Apart apart{keys, values};
    const Together together{pairs};
    for (int p = 0; p < passes; p += 2) {
      const Digit low{p * wide, wide}, high{(p + 1) * wide, wide};
      sort_by_digit(apart, together, count, low, thread, all, counts_of);
      sort_by_digit(together, apart, count, high, thread, all, counts_of);
    }
  }
}

}  // namespace omp
}  // namespace weft
