#include "bench/forces.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
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
constexpr const char* metric = "ns_per_directed_spring";

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
  return {name, world->spring_steps(), [world] { world->advance(); }};
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

/// A root and a division, and nothing else: what a directed spring takes at least.
Candidate floor_candidate(const char* isa) {
  auto data = std::make_shared<std::vector<float>>(64 * 64, 1.5f);
  constexpr int passes = 96;
  return {"floor: a root and a division", double(data->size()) * passes,
          [data, isa] { roots_and_divisions(isa, data->data(), data->size(), passes); }};
}

/// The floor over the time of a directed spring without its share of the integration.
double floor_share(const Interleaved& runs, size_t floor, size_t gather, size_t integration,
                   uint32_t n) {
  const double springs = 2.0 * (2.0 * n * (n - 1) + double(n - 1) * (n - 1));
  const double share = runs.median(integration) * double(n) * n / springs;
  return runs.median(floor) / (runs.median(gather) - share);
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
    Interleaved runs("forces");
    runs.add(candidate(name + ", grid gather", grid));
    runs.add(candidate(name + " mesh, gather", pair.gather));
    runs.add(candidate(name + " mesh, scatter native", pair.scatter));
    const size_t alone =
        runs.add({"integration", free->particle_steps(), [free] { free->advance(); }});
    const size_t floor = runs.add(floor_candidate(grid->isa()));
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
    times.resize(3);
    rows.insert(rows.end(), times.begin(), times.end());
    rows.push_back(row_of(name + ", floor / force calculation, grid gather", "ratio", "1",
                          floor_share(runs, floor, 0, alone, n)));
    rows.push_back(row_of(name + ", floor / force calculation, mesh gather", "ratio", "1",
                          floor_share(runs, floor, 1, alone, n)));
    const double integration = 1e-6 * runs.median(alone) * double(n) * n;
    const double edges = worlds[0]->spring_steps() / o.substeps / 2;
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
    std::vector<std::pair<size_t, size_t>> indices;
    std::vector<bool> scatters;
    for (const MeshCase& c : mesh_cases()) {
      const Pair pair = both_ways(c.sheet, precision);
      const std::string name = c.name + " " + to_string(precision);
      indices.emplace_back(runs.add(candidate(name + ", gather", pair.gather)),
                           runs.add(candidate(name + ", scatter native", pair.scatter)));
      Options o = with(Evaluation::automatic, Accumulate::native, precision);
      SteppedWorld chosen = SteppedWorld::mesh(c.sheet.positions, c.sheet.triangles, o);
      scatters.push_back((*chosen.world().plan()).evaluations[0].chosen == Evaluation::scatter);
      names.push_back(name);
      if (precision == Precision::float32 && c.name.rfind("256x256", 0) == 0) {
        const Valences v = valences_of(c.sheet);
        rows.push_back(row_of(c.name, "valence_least", "1", v.least));
        rows.push_back(row_of(c.name, "valence_most", "1", v.most));
      }
    }
    runs.run(quick ? 5 : 21, progress);
    runs.append_times(metric, "ns", rows);
    runs.append_ratio(names[1] + " / regular, gather", indices[1].first, indices[0].first, rows);
    runs.append_ratio(names[2] + " / regular, gather", indices[2].first, indices[0].first, rows);
    for (size_t i = 0; i < names.size(); ++i) {
      const double gather = runs.median(indices[i].first), scatter = runs.median(indices[i].second);
      const double chosen = scatters[i] ? scatter : gather;
      rows.push_back(
          row_of(names[i] + ", automatic " + (scatters[i] ? "scatter" : "gather") + " / best",
                 "ratio", "1", chosen / std::min(gather, scatter)));
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
  runs.append_ratio("floor / 256x256 tri6, grid gather", floor, of_grid, rows);
  runs.append_ratio("floor / 256x256 regular, sliced rows", floor, sliced[0], rows);
  runs.append_ratio("floor / 256x256 irregular, sliced rows", floor, sliced[1], rows);
  runs.append_ratio("every spring once / grid gather", once, of_grid, rows);
  for (int i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? "regular: " : "irregular: ";
    runs.append_ratio(name + "compressed / sliced rows", compressed[i], sliced[i], rows);
    runs.append_ratio(name + "padded / sliced rows", padded[i], sliced[i], rows);
  }
}

}  // namespace

std::vector<Row> run_forces(bool quick, std::ostream& progress) {
  std::vector<Row> rows;
  regular_sizes(quick, progress, rows);
  irregular_meshes(quick, progress, rows);
  layouts_and_sums(quick, progress, rows);
  return rows;
}

}  // namespace weft::bench
