#include "bench/collide.h"

#include <algorithm>
#include <cstdio>

#include "bench/collide_run.h"
#include "bench/collide_sets.h"
#include "io/predicted_recall.h"

namespace weft::bench {

namespace {

Row row_of(const std::string& name, const char* metric, const char* unit,
           std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  return {"collide",
          name,
          metric,
          unit,
          samples[samples.size() / 2],
          samples.front(),
          samples.back(),
          static_cast<int>(samples.size())};
}

/// A set of points, and how many places of the grids it is tried at.
struct Set {
  std::string name;
  std::vector<double3> points;
  double distance;
  int places;
};

struct Grids {
  uint32_t count;
  GridShifts shifts;
};
const std::vector<Grids> all_grids = {{1, GridShifts::corner},
                                      {2, GridShifts::corner},
                                      {4, GridShifts::corner},
                                      {8, GridShifts::corner},
                                      {4, GridShifts::diagonal}};
struct Sweep {
  std::vector<double> cells;  ///< in distances
  std::vector<uint32_t> windows;
  std::vector<Grids> grids;
};

SelfCollisionDesc complete(double distance) {
  SelfCollisionDesc desc;
  desc.distance = distance;
  return desc;
}

SelfCollisionDesc staggered(double distance, double cells, Grids grids, uint32_t window) {
  SelfCollisionDesc desc = complete(distance);
  desc.search = PairSearch::staggered;
  desc.cell = cells * distance;
  desc.grids = grids.count;
  desc.shifts = grids.shifts;
  desc.window = window;
  return desc;
}

/// Recall over places of the grids, and the time of a search and of a substep.
void append_search(const Set& set, const SelfCollisionDesc& desc, std::vector<Row>& rows) {
  const std::string name = set.name + ": " + name_of(desc);
  const double particles = double(set.points.size());
  std::vector<double> recall, search, step, wrong;
  double mean = 0;
  for (int place = 0; place < set.places; ++place) {
    Cloud cloud(moved(set.points, uint64_t(place) + 1), desc);
    const Cloud::Search found = cloud.search();
    recall.push_back(found.recall.recall());
    mean += recall.back() / set.places;
    wrong.push_back(double(found.recall.pairs_wrong));
    search.push_back(1e9 * found.seconds / particles);
    step.push_back(1e9 * cloud.step() / particles);
  }
  rows.push_back(row_of(name, "recall", "1", recall));
  rows.push_back(row_of(name, "mean_recall", "1", {mean}));
  rows.push_back(row_of(name, "pairs_wrong", "1", wrong));
  rows.push_back(row_of(name, "search", "ns/particle", search));
  rows.push_back(row_of(name, "substep", "ns/particle", step));
  const io::ExpectedRecall expected =
      io::expect_recall(desc, {{set.points, set.distance, true, true, ~0u}});
  if (expected.of_pairs) {
    rows.push_back(row_of(name, "expected_recall", "1", {*expected.of_pairs}));
  }
  if (const auto predicted = io::predicted_recall(desc)) {
    rows.push_back(row_of(name, "predicted_recall", "1", {*predicted}));
  }
}

void append_set(const Set& set, const Sweep& sweep, std::ostream& progress,
                std::vector<Row>& rows) {
  const io::MeetingCloth cloth{set.points, set.distance, true, true, ~0u};
  const auto pairs = double(io::count_near_pairs({cloth}));
  rows.push_back(row_of(set.name, "pairs", "1", {pairs}));
  rows.push_back(row_of(set.name, "near_points", "1", {2 * pairs / double(set.points.size())}));
  Set once = set;
  once.places = std::min(set.places, 3);
  append_search(once, complete(set.distance), rows);
  for (const double h : sweep.cells) {
    char name[128];
    std::snprintf(name, sizeof name, "%s: h = %g r", set.name.c_str(), h);
    rows.push_back(
        row_of(name, "points_per_cell", "1", {points_per_cell(set.points, h * set.distance)}));
    progress << "collide: " << set.name << ", cells of " << h << " r\n";
    for (const Grids grids : sweep.grids) {
      append_search(set, staggered(set.distance, h, grids, 0), rows);
      for (const uint32_t window : sweep.windows) {
        append_search(once, staggered(set.distance, h, grids, window), rows);
      }
    }
  }
}

}  // namespace

std::vector<Row> run_collide(bool quick, std::ostream& progress) {
  constexpr double r = 0.036840315, spacing = 1.0 / 127;
  const std::vector<double3> uniform = uniform_points(20000, 42);
  const std::vector<double3> crumpled = crumpled_sheet(128, 14, 0.004, 7);
  const Sweep all{{1, 2, 4}, {16, 8, 4, 2, 1}, all_grids}, less{{2}, {4}, all_grids};
  std::vector<Row> rows;
  append_set({"uniform", uniform, r, quick ? 2 : 32}, quick ? less : all, progress, rows);
  append_set({"crumpled, r = spacing", crumpled, spacing, quick ? 1 : 4}, quick ? less : all,
             progress, rows);
  if (!quick) {
    const Sweep crowds{{2}, {8, 4}, {{8, GridShifts::corner}}};
    append_set({"uniform, a quarter of the points", uniform_points(5000, 42), r, 3}, crowds,
               progress, rows);
    append_set({"uniform, four times the points", uniform_points(80000, 42), r, 3}, crowds,
               progress, rows);
    append_set({"crumpled, r = spacing/2", crumpled, spacing / 2, 3}, crowds, progress, rows);
    append_set({"crumpled, r = 2 spacing", crumpled, 2 * spacing, 3}, crowds, progress, rows);
  }
  append_folding(quick, progress, rows);
  return rows;
}

}  // namespace weft::bench
