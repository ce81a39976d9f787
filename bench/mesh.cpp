#include "bench/mesh.h"

#include <memory>

#include "bench/interleave.h"
#include "bench/mesh_files.h"
#include "bench/sheets.h"
#include "io/mesh.h"

namespace weft::bench {

namespace {

Candidate candidate_of(const std::string& name, SteppedWorld made) {
  auto world = std::make_shared<SteppedWorld>(std::move(made));
  return {name, world->spring_steps(), [world] { world->advance(); }};
}

}  // namespace

std::vector<Row> run_mesh(bool quick, std::ostream& progress) {
  Interleaved runs("mesh");
  const SteppedWorld::Options options;
  const size_t grid = runs.add(
      candidate_of("256x256 tri6 as a grid", SteppedWorld::sheet(256, Stencil::tri6, options)));
  const TriangleSheet sheet = triangle_sheet(256);
  std::vector<size_t> meshes{runs.add(candidate_of(
      "256x256 tri6 as a mesh", SteppedWorld::mesh(sheet.positions, sheet.triangles, options)))};
  std::vector<std::string> names{"tri6 mesh"};
  for (const auto& [name, file] : mesh_files()) {
    const io::Mesh mesh = io::read_mesh(file);
    SteppedWorld::Options more = options;
    more.substeps = static_cast<int>(8 * 65536 / mesh.positions.size()) + 1;
    meshes.push_back(
        runs.add(candidate_of(name, SteppedWorld::mesh(mesh.positions, mesh.triangles, more))));
    names.push_back(name);
  }
  runs.run(quick ? 9 : 31, progress);
  std::vector<Row> rows;
  runs.append_times("ns_per_directed_spring", "ns", rows);
  for (size_t i = 0; i < meshes.size(); ++i) {
    runs.append_ratio(names[i] + " / tri6 grid", meshes[i], grid, rows);
  }
  return rows;
}

}  // namespace weft::bench
