// The host back end's sorts by few bits against std::stable_sort.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "omp/sort.h"
#include "reference/random.h"

namespace weft::testing {
namespace {

using Words = std::vector<uint32_t>;

constexpr int threads_of_sorts[] = {1, 2, 3, 7};

/// Indices in order of their keys.
Words stable_order(const Words& keys) {
  Words order(keys.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return keys[a] < keys[b]; });
  return order;
}

Words taken(const Words& from, const Words& order) {
  Words out;
  for (const uint32_t i : order) out.push_back(from[i]);
  return out;
}

/// Sets of keys below 2^bits: all over, a few of them, alone at both ends, in rows as a sheet has.
std::vector<Words> sets_of_keys(int bits, size_t count) {
  reference::SplitMix random(static_cast<uint64_t>(bits) * 1000 + count);
  const uint64_t all = uint64_t(1) << bits;
  std::vector<Words> sets(4);
  for (size_t i = 0; i < count; ++i) {
    sets[0].push_back(static_cast<uint32_t>(random.bits() % all));
    sets[1].push_back(static_cast<uint32_t>(random.bits() % 5 * (all / 5) % all));
    sets[2].push_back(static_cast<uint32_t>(random.bits() % 2 * (all - 1)));
    sets[3].push_back(static_cast<uint32_t>((i % 50 + i / 150 * 50) % all));
  }
  return sets;
}

void expect_sorted_cells(const Words& keys, int bits, int threads) {
  SCOPED_TRACE(std::to_string(keys.size()) + " keys of " + std::to_string(bits) + " bits, " +
               std::to_string(threads) + " threads");
  const Words order = stable_order(keys), sorted_keys = taken(keys, order);
  Words starts;
  for (uint32_t c = 0; c <= 1u << bits; ++c) {
    starts.push_back(static_cast<uint32_t>(
        std::lower_bound(sorted_keys.begin(), sorted_keys.end(), c) - sorted_keys.begin()));
  }
  const size_t n = keys.size();
  Words indices(n, 77), alone(n, 77), keys_out(n, 77), starts_out(starts.size(), 77);
  std::vector<uint64_t> pairs(n);
  Words counts(omp::cell_sort_counts(bits, threads), 77);
  omp::CellSort sort{keys.data(),  nullptr,       indices.data(), nullptr, starts_out.data(),
                     pairs.data(), counts.data(), int(n),         bits};
  omp::sort_cells(sort, threads);
  EXPECT_EQ(indices, order);
  EXPECT_EQ(starts_out, starts);

  Words values(n);
  for (size_t i = 0; i < n; ++i) values[i] = static_cast<uint32_t>(4000000000u - 3 * i);
  const Words expected = taken(values, order);
  Words keys_in = keys;  // both are written over
  sort.keys = keys_in.data();
  sort.sorted_keys = keys_in.data();
  sort.values = values.data();
  sort.sorted = values.data();
  omp::sort_cells(sort, threads);
  EXPECT_EQ(values, expected);
  EXPECT_EQ(keys_in, sorted_keys);
  EXPECT_EQ(starts_out, starts);
}

TEST(CellSort, GivesTheOrderOfAStableSortAndWhereEachCellBegins) {
  for (int bits = 0; bits <= 22; ++bits) {
    const bool wide = bits > 16;
    for (const size_t count :
         {size_t(0), size_t(1), size_t(2), wide ? size_t(20000) : size_t(999)}) {
      if (wide && count < 3) continue;
      const std::vector<Words> sets = sets_of_keys(bits, count);
      for (size_t s = 0; s < (wide ? size_t(1) : sets.size()); ++s) {
        for (const int threads : threads_of_sorts) expect_sorted_cells(sets[s], bits, threads);
      }
    }
  }
}

TEST(FewBitsSort, GivesTheOrderOfAStableSortForEveryCountOfBits) {
  for (int bits = 0; bits <= 32; ++bits) {
    for (const size_t count : {size_t(0), size_t(1), size_t(2), size_t(3001)}) {
      for (const Words& keys : sets_of_keys(bits, count)) {
        const Words order = stable_order(keys), sorted_keys = taken(keys, order);
        for (const int threads : threads_of_sorts) {
          SCOPED_TRACE(std::to_string(count) + " keys of " + std::to_string(bits) + " bits, " +
                       std::to_string(threads) + " threads");
          Words k = keys, v(count);
          std::iota(v.begin(), v.end(), 0u);
          std::vector<uint64_t> pairs(count);
          omp::stable_sort_few_bits(k.data(), v.data(), pairs.data(), int(count), bits, threads);
          EXPECT_EQ(v, order);
          EXPECT_EQ(k, sorted_keys);
        }
      }
    }
  }
}

TEST(FewBitsSort, GivesTheOrderOfThrust) {
  for (const int bits : {7, 16, 20, 32}) {
    const Words keys = sets_of_keys(bits, 30000)[1];
    Words k = keys, v(keys.size());
    std::iota(v.begin(), v.end(), 0u);
    Words thrust_keys = keys, thrust_values = v;
    omp::stable_sort_by_key(thrust_keys.data(), thrust_values.data(), int(keys.size()), true);
    std::vector<uint64_t> pairs(keys.size());
    omp::stable_sort_few_bits(k.data(), v.data(), pairs.data(), int(keys.size()), bits, 2);
    EXPECT_EQ(k, thrust_keys);
    EXPECT_EQ(v, thrust_values);
  }
}

}  // namespace
}  // namespace weft::testing
