// What the plan has to know of a cloth.
#include <algorithm>

#include "api/arena/arena.h"
#include "api/arena/parts.h"
#include "scene/edges.h"
#include "scene/fan.h"
#include "scene/grid.h"

namespace weft::api {

KernelKind kind_of(const ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  static_assert(int(KernelKind::seed12) == int(Stencil::seed12) &&
                int(KernelKind::classic12) == int(Stencil::classic12) &&
                int(KernelKind::quad4) == int(Stencil::quad4) &&
                int(KernelKind::tri6) == int(Stencil::tri6));
  if (cloth.scatters) return fabric.is_grid ? KernelKind::scatter_grid : KernelKind::scatter_mesh;
  if (fabric.is_grid) return static_cast<KernelKind>(fabric.grid.stencil);
  return fabric.rows.stiffness.empty() ? KernelKind::mesh_uniform : KernelKind::mesh_per_spring;
}

static uint32_t blocks_of_moving_pins(const ClothRecord& cloth) {
  Vector<uint32_t> blocks;
  for (const PinRecord& pin : cloth.pins) {
    if (pin.can_move) blocks.push_back(cloth.cooked().storage(pin.vertex) / block_size);
  }
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return static_cast<uint32_t>(blocks.size());
}

plan::ClothShape shape_of(const ClothRecord& cloth, Accumulation accumulation, bool fans) {
  const scene::CookedFabric& fabric = cloth.cooked();
  plan::ClothShape shape{};
  shape.kind = kind_of(cloth);
  shape.particles = fabric.vertices;
  shape.directed_springs = 2 * fabric.springs;
  shape.parts = parts_of(cloth);
  shape.drag = cloth.drag > 0;
  shape.spring_damping = cloth.spring_damping > 0;
  shape.sleeps = cloth.sleep_speed > 0;
  shape.triangles = scene::triangle_count(fabric) > 0;
  if (cloth.scatters) {
    shape.edges = scene::padded_edges(fabric.springs);
    shape.row_entries = scene::incident_entries(fabric);
  } else if (!fabric.is_grid) {
    shape.row_entries = fabric.row_entries;
  }
  if (cloth.colours) {
    shape.colours = cloth.colours->count();
    shape.spring_blocks = static_cast<uint32_t>(cloth.colours->blocks.size());
    shape.coloured_springs = cloth.colours->springs.size();
    shape.ladder_springs = scene::ladder_springs(*cloth.colours);
  }
  if (fabric.is_grid) {
    const int radius = scene::stencil_radius(fabric.grid.stencil);
    const int columns = fabric.grid.rows > 1 ? static_cast<int>(fabric.grid.columns) : 0;
    shape.guard = radius * columns + radius;
  }
  if (fans) shape.triangle_entries = scene::fan_entries(fabric);
  shape.moving_pin_blocks = blocks_of_moving_pins(cloth);
  shape.motions = static_cast<uint32_t>(cloth.motions.size());
  if (cloth.scatters && uses_atomics(accumulation)) {  // which need no rows
    shape.row_entries = 0;
    return shape;
  }
  if (!fabric.hubs.empty()) {
    shape.hub_entries = fabric.row_entries - static_cast<int64_t>(fabric.slice_start.back());
  }
  shape.hubs = static_cast<uint32_t>(fabric.hubs.size());
  for (const scene::HubRow& hub : fabric.hubs) {
    shape.hub_springs += hub.count;
    shape.hub_chunks += (hub.count + hub_chunk - 1) / hub_chunk;
  }
  return shape;
}

}  // namespace weft::api
