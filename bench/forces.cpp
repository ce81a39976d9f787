#include "bench/forces.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "bench/floor.h"
#include "bench/interleave.h"
#include "bench/irregular.h"
#include "bench/layouts.h"
#include "bench/mesh_files.h"
#include "io/mesh.h"

namespace weft::bench {

namespace {

using Options = SteppedWorld::Options;
constexpr const char* metric = "ns_per_edge";

Row row_of(const std::string& name, const char* of, const char* unit, double value) {
  return {"forces", name, of, unit, value, value, value, 1};
}

std::string size_name(uint32_t n) { return std::to_string(n) + "x" + std::to_string(n); }

Options with(Evaluation evaluation, Accumulate accumulate = Accumulate::native,
             Precision precision = Precision::float32) {
  Options o;
  o.evaluation = evaluation;
  o.accumulate = accumulate;
  o.precision = precision;
  return o;
}

/// About half a million directed springs in a call: milliseconds.
int substeps_for(size_t vertices) {
  return std::max(1, static_cast<int>(8 * 65536 / std::max<size_t>(vertices, 1)));
}

/// The two ways to evaluate one mesh.
struct Pair {
  std::shared_ptr<SteppedWorld> gather, scatter;
};
Pair both_ways(const TriangleSheet& sheet, Precision precision) {
  Pair pair;
  for (const Evaluation e : {Evaluation::gather, Evaluation::scatter}) {
    Options o = with(e, Accumulate::native, precision);
    o.substeps = substeps_for(sheet.positions.size());
    o.profile = true;
    (e == Evaluation::gather ? pair.gather : pair.scatter) =
        std::make_shared<SteppedWorld>(SteppedWorld::mesh(sheet.positions, sheet.triangles, o));
  }
  return pair;
}
Candidate candidate(const std::string& name, const std::shared_ptr<SteppedWorld>& world) {
  return {name, world->edge_steps(), [world] { world->advance(); }};
}

/// A root and a division, and nothing else: what evaluating a spring takes at least.
template <class T = float>
Candidate floor_candidate(const char* isa) {
  auto data = std::make_shared<std::vector<T>>(64 * 64, T(1.5));
  constexpr int passes = 96;
  return {"floor: a root and a division", double(data->size()) * passes,
          [data, isa] { roots_and_divisions(isa, data->data(), data->size(), passes); }};
}
/// A byte of a copy of as much memory as a world has, wherever that much lies.
Candidate copy_candidate(SteppedWorld& world) {
  const auto half = static_cast<size_t>(world.world().stats().bytes_state / 2);
  auto data = std::make_shared<std::vector<char>>(2 * half, char(1));
  return {"floor: copy", double(2 * half),
          [data, half] { std::memcpy(data->data() + half, data->data(), half); }};
}

/// The bytes of a world, and its time against the larger of two floors: its roots and divisions,
/// and the bytes that the plan says.
void append_floor(const Interleaved& runs, size_t timed, size_t roots, size_t copy, int evaluations,
                  SteppedWorld& world, std::vector<Row>& rows) {
  const double edges = world.edge_steps() / world.substeps();
  const double arithmetic = evaluations * runs.median(roots);
  const double bandwidth = world.bytes_per_step() / edges * runs.median(copy);
  const std::string name = runs.name(timed);
  rows.push_back(row_of(name, "bytes", "B", double(world.world().stats().bytes_state)));
  rows.push_back(row_of(name, "arithmetic_floor", "ns", arithmetic));
  rows.push_back(row_of(name, "bandwidth_floor", "ns", bandwidth));
  rows.push_back(
      row_of(name, "floor_share", "1", std::max(arithmetic, bandwidth) / runs.median(timed)));
}

/// What the automatic choice takes, against the better of the two.
void append_choice(const std::string& name, SteppedWorld chosen, double gather, double scatter,
                   std::vector<Row>& rows) {
  const Evaluation e = (*chosen.world().plan()).evaluations[0].chosen;
  const double time = e == Evaluation::scatter ? scatter : gather;
  rows.push_back(row_of(name + ", automatic " + to_string(e) + " / best", "ratio", "1",
                        time / std::min(gather, scatter)));
}

double phase(World& world, const char* name) {
  const Stats stats = world.stats();
  for (uint32_t i = 0; i < stats.phases.count; ++i) {
    if (std::strcmp(stats.phases[i].name, name) == 0) return stats.phases[i].seconds;
  }
  throw std::runtime_error(std::string("forces: no phase ") + name);
}

/// Table 1: memory, reads, dependent reads and operations of a substep, counted from the plan,
/// whose bytes must be those that are allocated.
void table_1(const std::string& name, SteppedWorld& world, double edges, double entries,
             std::vector<Row>& rows) {
  const PlanInfo plan = *world.world().plan();
  const double allocated = double(world.world().stats().bytes_state);
  if (double(plan.bytes_state) != allocated) {
    throw std::runtime_error("forces: the plan says " + std::to_string(plan.bytes_state) +
                             " bytes, allocated are " + std::to_string(allocated));
  }
  double flops = 0;
  for (uint32_t i = 0; i < plan.passes.count; ++i) {
    const PassInfo& pass = plan.passes[i];
    if (std::strcmp(pass.per, "substep") == 0) {
      flops += pass.flops_per_particle * double(pass.count);
    }
  }
  const bool scatters = plan.evaluations[0].chosen == Evaluation::scatter;
  // Gather: itself and what each entry says; the neighbour. Scatter: what each edge says and, for
  // each end, which edge; the two ends, and the force of each.
  const double reads = scatters ? edges + entries : world.particles() + entries;
  const double dependent = scatters ? 2 * edges + entries : entries;
  rows.push_back(row_of(name, "memory", "B", allocated));
  rows.push_back(row_of(name, "reads", "per substep", reads));
  rows.push_back(row_of(name, "dependent_reads", "per substep", dependent));
  rows.push_back(row_of(name, "operations", "flop", flops));
}

/// Table 2: how long the parts of a substep take, in ms.
void table_2(const std::string& name, SteppedWorld& world, double integration_ms, double calls,
             const double before[2], std::vector<Row>& rows) {
  const double springs = 1e3 * (phase(world.world(), "advance.springs") - before[0]) / calls;
  const double rest = 1e3 * (phase(world.world(), "advance.particles") - before[1]) / calls;
  if (springs > 0) {
    rows.push_back(row_of(name, "force_calculation", "ms", springs));
    rows.push_back(row_of(name, "force_accumulation", "ms", std::max(0.0, rest - integration_ms)));
  } else {
    rows.push_back(row_of(name, "force_calculation", "ms", std::max(0.0, rest - integration_ms)));
  }
  rows.push_back(row_of(name, "integration", "ms", integration_ms));
  rows.push_back(row_of(name, "total", "ms", springs + rest));
}

/// The floor over the time of a gathered spring without its share of the integration.
double floor_share(const Interleaved& runs, size_t floor, size_t gather, size_t integration,
                   uint32_t n) {
  const double edges = 2.0 * n * (n - 1) + double(n - 1) * (n - 1);
  const double share = runs.median(integration) * double(n) * n / edges;
  return 2 * runs.median(floor) / (runs.median(gather) - share);
}

void regular_sizes(bool quick, std::ostream& progress, std::vector<Row>& rows) {
  std::vector<uint32_t> sizes{128, 256, 512};
  if (!quick) sizes.insert(sizes.end(), {1024, 2048});
  for (const uint32_t n : sizes) {
    const TriangleSheet sheet = triangle_sheet(n);
    const Pair pair = both_ways(sheet, Precision::float32);
    Options o;
    o.substeps = substeps_for(sheet.positions.size());
    auto grid = std::make_shared<SteppedWorld>(SteppedWorld::sheet(n, Stencil::tri6, o));
    auto free = std::make_shared<SteppedWorld>(SteppedWorld::particles(n * n, o));
    const std::string name = size_name(n) + " tri6";
    Options once = with(Evaluation::scatter);
    once.substeps = o.substeps;
    auto grid_scatter = std::make_shared<SteppedWorld>(SteppedWorld::sheet(n, Stencil::tri6, once));
    Interleaved runs("forces");
    const size_t of_grid = runs.add(candidate(name + ", grid gather", grid));
    const size_t gather = runs.add(candidate(name + " mesh, gather", pair.gather));
    const size_t scatter = runs.add(candidate(name + " mesh, scatter native", pair.scatter));
    const size_t grid_once = runs.add(candidate(name + ", grid scatter native", grid_scatter));
    const size_t alone =
        runs.add({"integration", free->particle_steps(), [free] { free->advance(); }});
    const size_t floor = runs.add(floor_candidate(grid->isa()));
    const size_t copy[] = {runs.add(copy_candidate(*grid)), runs.add(copy_candidate(*pair.gather)),
                           runs.add(copy_candidate(*pair.scatter))};
    double before[2][2];
    const std::shared_ptr<SteppedWorld> worlds[] = {pair.gather, pair.scatter};
    for (int w = 0; w < 2; ++w) {
      before[w][0] = phase(worlds[w]->world(), "advance.springs");
      before[w][1] = phase(worlds[w]->world(), "advance.particles");
    }
    const int rounds = quick ? 5 : 15;
    runs.run(rounds, progress);
    std::vector<Row> times;
    runs.append_times(metric, "ns", times);
    times.resize(4);
    rows.insert(rows.end(), times.begin(), times.end());
    rows.push_back(row_of(name + ", floor / force calculation, grid gather", "ratio", "1",
                          floor_share(runs, floor, of_grid, alone, n)));
    rows.push_back(row_of(name + ", floor / force calculation, mesh gather", "ratio", "1",
                          floor_share(runs, floor, gather, alone, n)));
    append_floor(runs, of_grid, floor, copy[0], 2, *grid, rows);
    append_floor(runs, gather, floor, copy[1], 2, *pair.gather, rows);
    append_floor(runs, scatter, floor, copy[2], 1, *pair.scatter, rows);
    Options automatic = with(Evaluation::automatic);
    append_choice(name + ", grid", SteppedWorld::sheet(n, Stencil::tri6, automatic),
                  runs.median(of_grid), runs.median(grid_once), rows);
    append_choice(name + " mesh", SteppedWorld::mesh(sheet.positions, sheet.triangles, automatic),
                  runs.median(gather), runs.median(scatter), rows);
    const double integration = 1e-6 * runs.median(alone) * double(n) * n;
    const double edges = worlds[0]->edge_steps() / o.substeps;
    for (int w = 0; w < 2; ++w) {
      const std::string of = name + (w == 0 ? " mesh, gather" : " mesh, scatter native");
      table_1(of, *worlds[w], edges, 2 * edges, rows);
      table_2(of, *worlds[w], integration, double(o.substeps) * (rounds + 1), before[w], rows);
    }
  }
}

struct MeshCase {
  std::string name;
  TriangleSheet sheet;
};

std::vector<MeshCase> mesh_cases() {
  std::vector<MeshCase> cases{{"256x256 regular", triangle_sheet(256)},
                              {"256x256 irregular", irregular_sheet(256, false)},
                              {"256x256 irregular, shuffled", irregular_sheet(256, true)}};
  for (const auto& [name, file] : mesh_files()) {
    const io::Mesh mesh = io::read_mesh(file);
    cases.push_back({name, {mesh.positions, mesh.triangles}});
  }
  return cases;
}

/// Gather, scatter and what the automatic choice would take, on every mesh in both precisions.
void irregular_meshes(bool quick, std::ostream& progress, std::vector<Row>& rows) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Interleaved runs("forces");
    std::vector<std::string> names;
    std::vector<MeshCase> cases = mesh_cases();
    std::vector<Pair> pairs;
    std::vector<std::pair<size_t, size_t>> indices, copies;
    for (const MeshCase& c : cases) {
      const Pair pair = both_ways(c.sheet, precision);
      const std::string name = c.name + " " + to_string(precision);
      indices.emplace_back(runs.add(candidate(name + ", gather", pair.gather)),
                           runs.add(candidate(name + ", scatter native", pair.scatter)));
      copies.emplace_back(runs.add(copy_candidate(*pair.gather)),
                          runs.add(copy_candidate(*pair.scatter)));
      pairs.push_back(pair);
      names.push_back(name);
      if (precision == Precision::float32 && c.name.rfind("256x256", 0) == 0) {
        const Valences v = valences_of(c.sheet);
        rows.push_back(row_of(c.name, "valence_least", "1", v.least));
        rows.push_back(row_of(c.name, "valence_most", "1", v.most));
      }
    }
    const char* isa = pairs[0].gather->isa();
    const size_t floor = runs.add(precision == Precision::float32 ? floor_candidate<float>(isa)
                                                                  : floor_candidate<double>(isa));
    runs.run(quick ? 5 : 21, progress);
    std::vector<Row> times;
    runs.append_times(metric, "ns", times);
    for (Row& row : times) {
      if (row.name.rfind("floor", 0) != 0) rows.push_back(std::move(row));
    }
    runs.append_ratio(names[1] + " / regular, gather", indices[1].first, indices[0].first, rows);
    runs.append_ratio(names[2] + " / regular, gather", indices[2].first, indices[0].first, rows);
    for (size_t i = 0; i < names.size(); ++i) {
      append_floor(runs, indices[i].first, floor, copies[i].first, 2, *pairs[i].gather, rows);
      append_floor(runs, indices[i].second, floor, copies[i].second, 1, *pairs[i].scatter, rows);
      const TriangleSheet& sheet = cases[i].sheet;
      append_choice(names[i],
                    SteppedWorld::mesh(sheet.positions, sheet.triangles,
                                       with(Evaluation::automatic, Accumulate::native, precision)),
                    runs.median(indices[i].first), runs.median(indices[i].second), rows);
    }
  }
}

/// Ways to store and to add up, at 256 x 256, with the floor of roots and divisions.
void layouts_and_sums(bool quick, std::ostream& progress, std::vector<Row>& rows) {
  constexpr uint32_t n = 256;
  Interleaved runs("forces");
  const TriangleSheet regular = triangle_sheet(n), irregular = irregular_sheet(n, false);
  Options o;
  auto grid = std::make_shared<SteppedWorld>(SteppedWorld::sheet(n, Stencil::tri6, o));
  const char* isa = grid->isa();
  const size_t of_grid = runs.add(candidate("256x256 tri6, grid gather, again", grid));
  const size_t once = runs.add(each_once("256x256 tri6, grid, every spring once", n, isa));
  size_t sliced[2], compressed[2], padded[2];
  for (int i = 0; i < 2; ++i) {
    const TriangleSheet& sheet = i == 0 ? regular : irregular;
    const std::string name = i == 0 ? "256x256 regular, " : "256x256 irregular, ";
    sliced[i] = runs.add(candidate(
        name + "sliced rows",
        std::make_shared<SteppedWorld>(SteppedWorld::mesh(sheet.positions, sheet.triangles, o))));
    compressed[i] = runs.add(compressed_rows(name + "compressed rows", sheet, isa));
    padded[i] = runs.add(padded_rows(name + "padded rows", sheet, isa));
    rows.push_back(row_of(name + "padded rows", "bytes_of_springs", "B", padded_bytes(sheet)));
  }
  for (const Accumulate a :
       {Accumulate::native, Accumulate::atomic, Accumulate::fixed64, Accumulate::float16,
        Accumulate::float24, Accumulate::float24_all, Accumulate::fixed8}) {
    Options of = with(Evaluation::scatter, a);
    of.substeps = 2;
    runs.add(candidate(std::string("256x256 regular, scatter ") + to_string(a),
                       std::make_shared<SteppedWorld>(
                           SteppedWorld::mesh(regular.positions, regular.triangles, of))));
  }
  const size_t floor = runs.add(floor_candidate(isa));
  runs.run(quick ? 5 : 21, progress);
  runs.append_times(metric, "ns", rows);
  runs.append_ratio("two floors / 256x256 tri6, grid gather", floor, of_grid, rows, 2);
  runs.append_ratio("two floors / 256x256 regular, sliced rows", floor, sliced[0], rows, 2);
  runs.append_ratio("two floors / 256x256 irregular, sliced rows", floor, sliced[1], rows, 2);
  runs.append_ratio("every spring once / grid gather", once, of_grid, rows);
  for (int i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? "regular: " : "irregular: ";
    runs.append_ratio(name + "compressed / sliced rows", compressed[i], sliced[i], rows);
    runs.append_ratio(name + "padded / sliced rows", padded[i], sliced[i], rows);
  }
}

/// How much two threads gain where long rows lie together: a network of which one half has twenty
/// neighbours for every vertex, the other four.
void shares(bool quick, std::ostream& progress, std::vector<Row>& rows) {
  constexpr uint32_t n = 65536;
  std::vector<double3> positions;
  std::vector<Spring> springs;
  for (uint32_t v = 0; v < n; ++v) {
    positions.push_back({1e-3 * double(v), 0, 0});
    const uint32_t most = v < n / 2 ? 10 : 2;
    for (uint32_t k = 1; k <= most && v + k < n; ++k) springs.push_back({v, v + k});
  }
  Interleaved runs("forces");
  size_t index[2];
  for (uint32_t threads : {1u, 2u}) {
    Options o;
    o.threads = threads;
    index[threads - 1] = runs.add(
        candidate("network of valence 20 and 4, " + std::to_string(threads) + " threads",
                  std::make_shared<SteppedWorld>(SteppedWorld::network(positions, springs, o))));
  }
  runs.run(quick ? 5 : 21, progress);
  runs.append_times(metric, "ns", rows);
  runs.append_ratio("network of valence 20 and 4, 1 thread / 2 threads", index[0], index[1], rows);
}

}  // namespace

std::vector<Row> run_forces(bool quick, std::ostream& progress) {
  std::vector<Row> rows;
  regular_sizes(quick, progress, rows);
  irregular_meshes(quick, progress, rows);
  layouts_and_sums(quick, progress, rows);
  shares(quick, progress, rows);
  return rows;
}

}  // namespace weft::bench
