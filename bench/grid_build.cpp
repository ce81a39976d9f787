#include "bench/grid_build.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "bench/interleave.h"
#include "bench/random.h"
#include "omp/sort.h"

namespace weft::bench {

namespace {

/// Points with the grid of cells that a search for neighbours lays over them, and every array that
/// a way to build it needs.
struct Grid {
  std::vector<float> x, y, z;
  float cell = 1;
  uint32_t columns_ = 1, rows_ = 1;
  int bits = 0;
  std::vector<uint32_t> keys, other_keys, values, starts, counts;
  std::vector<uint64_t> room;
  std::vector<std::pair<uint32_t, uint32_t>> pairs;

  int count() const { return static_cast<int>(x.size()); }

  /// As many cells as particles, those further away wrapped onto them.
  void allocate() {
    while ((1 << bits) < count()) ++bits;
    keys.resize(x.size());
    other_keys.resize(x.size());
    values.resize(x.size());
    room.resize(x.size());
    pairs.resize(x.size());
    starts.resize((size_t(1) << bits) + 1);
    counts.resize(omp::cell_sort_counts(bits, 1));
  }
  void compute_keys() {
    const float scale = 1 / cell;
    const uint32_t columns = columns_, rows = rows_, last = (1u << bits) - 1;
    for (size_t i = 0; i < x.size(); ++i) {
      const auto column = static_cast<uint32_t>(static_cast<int>(x[i] * scale));
      const auto row = static_cast<uint32_t>(static_cast<int>(y[i] * scale));
      const auto layer = static_cast<uint32_t>(static_cast<int>(z[i] * scale));
      keys[i] = (column + columns * (row + rows * layer)) & last;
    }
  }
  /// From keys in order: the last of a cell leaves where the next one begins.
  void find_ranges() {
    std::fill(starts.begin(), starts.end(), 0u);
    for (size_t i = 0; i < keys.size(); ++i) {
      starts[keys[i] + 1] = static_cast<uint32_t>(i) + 1;
    }
    uint32_t most = 0;
    for (uint32_t& start : starts) start = most = std::max(most, start);
  }

  void build() {
    compute_keys();
    omp::sort_cells({keys.data(), nullptr, values.data(), nullptr, starts.data(), room.data(),
                     counts.data(), count(), bits},
                    1);
  }
  void build_with_thrust() {
    compute_keys();
    std::iota(values.begin(), values.end(), 0u);
    omp::stable_sort_by_key(keys.data(), values.data(), count(), true);
    find_ranges();
  }
  void build_with_few_bits() {
    compute_keys();
    std::iota(values.begin(), values.end(), 0u);
    omp::stable_sort_few_bits(keys.data(), values.data(), room.data(), count(), bits, 1);
    find_ranges();
  }
  /// The sort alone is what the others are judged by; the ranges are not counted.
  void sort_pairs() {
    for (size_t i = 0; i < keys.size(); ++i) pairs[i] = {keys[i], static_cast<uint32_t>(i)};
    std::sort(pairs.begin(), pairs.end());
  }
};

/// One point to a cell, anywhere in a cube of 1 m.
std::shared_ptr<Grid> uniform_points(uint32_t count) {
  auto grid = std::make_shared<Grid>();
  Random random(42);
  for (uint32_t i = 0; i < count; ++i) {
    grid->x.push_back(static_cast<float>(random.uniform()));
    grid->y.push_back(static_cast<float>(random.uniform()));
    grid->z.push_back(static_cast<float>(random.uniform()));
  }
  grid->cell = static_cast<float>(std::cbrt(1.0 / count));
  grid->columns_ = grid->rows_ = static_cast<uint32_t>(1 / grid->cell) + 1;
  grid->allocate();
  return grid;
}

/// A wavy sheet of 1 m, row by row, in cells of 0.9 spacings.
std::shared_ptr<Grid> sheet_points(uint32_t count) {
  auto grid = std::make_shared<Grid>();
  const auto side = static_cast<uint32_t>(std::lround(std::sqrt(count)));
  for (uint32_t i = 0; i < count; ++i) {
    const float u = static_cast<float>(i % side) / static_cast<float>(side);
    const float v = static_cast<float>(i / side) / static_cast<float>(side);
    grid->x.push_back(u);
    grid->y.push_back(0.1f + 0.1f * std::sin(9 * u + 4 * v));
    grid->z.push_back(v);
  }
  grid->cell = 0.9f / static_cast<float>(side);
  grid->columns_ = static_cast<uint32_t>(1 / grid->cell) + 1;
  grid->rows_ = static_cast<uint32_t>(0.2f / grid->cell) + 1;
  grid->allocate();
  return grid;
}

struct Ways {
  size_t std_sort, thrust, few_bits, ours;
};

Ways add_ways(Interleaved& runs, const std::string& name, const std::shared_ptr<Grid>& grid) {
  grid->compute_keys();
  // Each has arrays of its own, since Thrust leaves the keys in order.
  const auto thrust = std::make_shared<Grid>(*grid), few = std::make_shared<Grid>(*grid);
  const auto sorted = std::make_shared<Grid>(*grid);
  const double n = grid->count();
  const int times = n < 1e6 ? 16 : 4;
  const auto repeat = [&](const char* way, auto build) {
    return runs.add({name + ", " + way, n * times, [build, times] {
                       for (int i = 0; i < times; ++i) build();
                     }});
  };
  return {repeat("std::sort of pairs", [sorted] { sorted->sort_pairs(); }),
          repeat("Thrust", [thrust] { thrust->build_with_thrust(); }),
          repeat("stable_sort_few_bits", [few] { few->build_with_few_bits(); }),
          repeat("sort_cells", [grid] { grid->build(); })};
}

}  // namespace

std::vector<Row> run_grid_build(bool quick, std::ostream& progress) {
  std::vector<Row> rows;
  for (const uint32_t count : {65536u, 1048576u}) {
    Interleaved runs("grid_build");
    std::vector<std::pair<std::string, Ways>> all;
    for (const bool sheet : {false, true}) {
      const std::string name =
          std::to_string(count) + (sheet ? " of a sheet, row by row" : " points anywhere");
      all.emplace_back(name,
                       add_ways(runs, name, sheet ? sheet_points(count) : uniform_points(count)));
    }
    runs.run(quick ? 9 : 31, progress);
    runs.append_times("ns_per_particle", "ns", rows);
    for (const auto& [name, ways] : all) {
      runs.append_ratio(name + ", std::sort / sort_cells", ways.std_sort, ways.ours, rows);
      runs.append_ratio(name + ", Thrust / sort_cells", ways.thrust, ways.ours, rows);
    }
  }
  return rows;
}

}  // namespace weft::bench
