// Sort and scan of the host back end; compiled once, apart from the kernels, with Thrust. `alone`:
// on the calling thread, without OpenMP.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace weft {
namespace omp {

void exclusive_scan(const uint32_t* in, uint32_t* out, int count, bool alone);
void stable_sort_by_key(uint32_t* keys, uint32_t* values, int count, bool alone);

/// Particles in order of their cells, those of one cell in the order in which they were given: what
/// stable_sort_by_key gives, and where each cell begins. No memory is allocated.
///
/// The particles are dealt to buckets by the upper bits of their keys, in few enough buckets that
/// all of them are written from the cache; then each bucket, a piece of both tables that stays in
/// the cache, is counted and placed by the lower bits. The counts are the starts of the cells.
struct CellSort {
  const uint32_t* keys;    ///< [count], each below 2^bits
  const uint32_t* values;  ///< [count], what is sorted; null: 0, 1, 2, ...
  uint32_t* sorted;        ///< out [count]: the values; may be `keys` or `values`
  uint32_t* sorted_keys;   ///< out [count], or null; may be `keys` or `values`
  uint32_t* starts;        ///< out [2^bits + 1]: those of cell c are [starts[c], starts[c + 1])
  void* room;              ///< 8 bytes for each, aligned to 8
  uint32_t* counts;        ///< room [cell_sort_counts(bits, threads)]
  int count;               ///< particles
  int bits;                ///< of a key, 0 to 30
};

size_t cell_sort_counts(int bits, int threads);
/// Opens a parallel region of its own where threads > 1.
void sort_cells(const CellSort&, int threads);
/// The three parts of it for the threads of a region that is open: all meet after each.
void count_cells(const CellSort&, int thread, int threads);
void deal_cells(const CellSort&, int thread, int threads);
void place_cells(const CellSort&, int thread, int threads);

/// Sorts pairs of which only the lowest `bits` (0 to 32) of a key can differ from 0; equal keys
/// keep their order. `pairs`: room for `count`. No memory is allocated.
void stable_sort_few_bits(uint32_t* keys, uint32_t* values, uint64_t* pairs, int count, int bits,
                          int threads);

}  // namespace omp
}  // namespace weft
