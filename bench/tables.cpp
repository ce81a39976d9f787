#include "bench/bench.h"
#include "bench/grid.h"
#include "bench/mesh.h"

namespace weft::bench {

const std::vector<Table>& tables() {
  static const std::vector<Table> all = {
      {"grid", "the chapter's loop (Listing 22.1) against weft, threads, precisions, sizes",
       run_grid},
      {"mesh", "gather over meshes per directed spring, against the grid's", run_mesh},
  };
  return all;
}

}  // namespace weft::bench
