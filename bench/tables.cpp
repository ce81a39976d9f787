#include "bench/bench.h"

#include "bench/accumulate.h"
#include "bench/api.h"
#include "bench/collide.h"
#include "bench/effects.h"
#include "bench/forces.h"
#include "bench/gpu.h"
#include "bench/grid.h"
#include "bench/grid_build.h"
#include "bench/mesh.h"
#include "bench/stretch.h"

namespace weft::bench {

/// What the project's figures are judged by, in one command.
static std::vector<Row> run_grid_and_mesh(bool quick, std::ostream& progress) {
  std::vector<Row> rows = run_grid(quick, progress);
  for (Row& row : run_mesh(quick, progress)) rows.push_back(std::move(row));
  return rows;
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all = {
      {"grid", "the chapter's loop (Listing 22.1) against weft; threads, precisions, sizes, meshes",
       run_grid_and_mesh},
      {"api", "a call, many cloths, and vertices on their way out", run_api},
      {"effects", "what each effect adds, where it is used and where it has nothing to do",
       run_effects},
      {"gpu", "a frame of 16 substeps on the GPU: sizes, precisions, many cloths, effects",
       run_gpu},
      {"grid_build", "the cells of self-collision, one thread: keys, order and ranges",
       run_grid_build},
      {"mesh", "gather over meshes per directed spring, against the grid's", run_mesh},
      {"forces", "gather against scatter: memory, parts of a step, meshes, layouts and sums",
       run_forces},
      {"accumulate", "what the precision of the sum of forces does to forces and to equilibrium",
       run_accumulate},
      {"collide", "self-collision: pairs found and time, by search, set of points and step size",
       run_collide},
      {"stretch", "what keeps cloth from stretching costs: methods, substeps, stiffness, motion",
       run_stretch},
  };
  return all;
}

}  // namespace weft::bench
