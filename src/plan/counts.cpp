#include <algorithm>

#include "plan/plan.h"
#include "plan/shape.h"

namespace weft::plan {

namespace {

ClothCounts counts_of(const WorldShape& world, const ClothShape& cloth) {
  const int64_t blocks = cloth.blocks();
  ClothCounts n{};
  n.cloths = 1;
  n.particles = blocks * block_size;
  n.motions = cloth.motions;
  n.pin_blocks = cloth.moving_pin_blocks;
  n.survey_groups = (blocks + survey_blocks - 1) / survey_blocks;
  if (is_grid(cloth.kind)) n.grid_particles = n.particles;
  if (scatters(cloth.kind)) {
    n.scatter_slices = blocks;
    n.edges = static_cast<int64_t>(cloth.edges);
    n.incident = cloth.row_entries - cloth.hub_entries;
    n.hub_incident = cloth.hub_entries;
  } else if (!is_grid(cloth.kind)) {
    n.row_slices = blocks;
    n.row_entries = cloth.row_entries - cloth.hub_entries;
    n.hub_entries = cloth.hub_entries;
    if (cloth.kind == KernelKind::mesh_per_spring) n.own_stiffness = cloth.row_entries;
  }
  n.hubs = cloth.hubs;
  n.spring_blocks = cloth.spring_blocks;
  n.coloured_springs = static_cast<int64_t>(cloth.coloured_springs);
  n.hub_chunks = cloth.hub_chunks;
  if (!is_grid(cloth.kind) && (world.wind || world.normals)) {
    n.fan_slices = blocks;
    n.corners = cloth.triangle_entries;
  }
  for (int k = 0; k < part_count; ++k) {
    if (cloth.has(static_cast<Part>(k))) n.part[k] = n.particles;
  }
  return n;
}

void add(const ClothCounts& more, ClothCounts& n) {
  n.cloths += more.cloths;
  n.particles += more.particles;
  n.grid_particles += more.grid_particles;
  n.row_slices += more.row_slices;
  n.row_entries += more.row_entries;
  n.hub_entries += more.hub_entries;
  n.own_stiffness += more.own_stiffness;
  n.scatter_slices += more.scatter_slices;
  n.edges += more.edges;
  n.incident += more.incident;
  n.hub_incident += more.hub_incident;
  n.hubs += more.hubs;
  n.spring_blocks += more.spring_blocks;
  n.coloured_springs += more.coloured_springs;
  n.hub_chunks += more.hub_chunks;
  n.fan_slices += more.fan_slices;
  n.corners += more.corners;
  n.pin_blocks += more.pin_blocks;
  n.motions += more.motions;
  n.survey_groups += more.survey_groups;
  for (int k = 0; k < part_count; ++k) n.part[k] += more.part[k];
}

/// What does not grow from cloth to cloth.
void note(const WorldShape& world, const ClothShape& cloth, const ClothCounts& own, Counts& n) {
  n.guard = std::max<int64_t>(n.guard, cloth.guard);
  if (cloth.kind < KernelKind::scatter_grid) n.first_scatter_block += cloth.blocks();
  if (cloth.kind <= KernelKind::scatter_mesh) n.first_row_block += cloth.blocks();
  if (is_grid(cloth.kind)) n.first_mesh_block += cloth.blocks();
  const bool blown = world.wind && cloth.triangles && cloth.particles > 0;
  n.reads_velocities |= blown || cloth.spring_damping;
  n.damped_edges |= scatters(cloth.kind) && cloth.spring_damping;
  n.damped_hubs |= own.hubs > 0 && cloth.spring_damping;
  n.uses_activity |= cloth.sleeps;
}

}  // namespace

Vector<ClothCounts> places_of(const WorldShape& world) {
  Vector<ClothCounts> places(1);
  places[0].motions = 1;
  for (const ClothShape& cloth : world.cloths) {
    places.push_back(places.back());
    add(counts_of(world, cloth), places.back());
  }
  return places;
}

int64_t first_list_entries(const WorldShape& world) {
  if (world.contact_grids == 0) return 0;
  int64_t particles = 0;
  for (const ClothShape& cloth : world.cloths) particles += int64_t(cloth.blocks()) * block_size;
  return particles > 0 ? std::max<int64_t>(4096, 2 * particles) : 0;
}

uint64_t list_entry_bytes(const WorldShape& world) { return sizeof(int32_t) + world.scalar(); }

Counts counts_of(const WorldShape& world) {
  Counts n{};
  n.motions = 1;
  for (const ClothShape& cloth : world.cloths) {
    const ClothCounts own = counts_of(world, cloth);
    add(own, n);
    note(world, cloth, own, n);
  }
  for (int shape = 0; shape < collider_shapes; ++shape) {
    n.colliders[shape] = world.colliders[shape];
    n.all_colliders += world.colliders[shape];
  }
  n.turns = world.turning_colliders;
  n.substeps = world.substeps;
  n.position_form = world.position_form;
  n.projects = world.projects;
  n.keeps_before = world.interpolate;
  n.collides = n.all_colliders > 0 && n.cloths > 0;
  n.uses_activity |= n.collides;
  n.meets_meshes = !world.meshes.empty();
  if (world.contact_grids > 0 && n.particles > 0) {
    n.contact_grids = world.contact_grids;
    n.staggered = world.staggered;
    n.contact_groups = world.contact_groups;
    // Some eight cells a particle, so that few share one without being near, and four along each
    // axis.
    n.key_bits = 6;
    while (n.key_bits < 26 && (int64_t(1) << n.key_bits) < 8 * n.particles) ++n.key_bits;
    if (n.staggered) n.key_bits = 32;
    n.reads_velocities = true;
    n.uses_activity = true;
  }
  n.accumulation = static_cast<int32_t>(world.accumulation);
  n.full_scale = world.full_scale;
  return n;
}

}  // namespace weft::plan
