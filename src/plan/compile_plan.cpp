#include "plan/plan.h"

#include <algorithm>

#include "weft/plan.hpp"

namespace weft::plan {

namespace {

// Additions, multiplications, divisions and roots of the kernels, counted from their source.
constexpr double spring_flops = 18;          // kernels/spring.h with the difference and the sum
constexpr double spring_damping_flops = 22;  // the same, with velocities
constexpr double sum_flops = 3;              // of a force that is there already
constexpr double integrate_flops = 22;       // w f + g, r d + h a, x + d
constexpr double drag_flops = 10;
// kernels/project_springs.h: difference, length, scale, two ends; with what l has gained.
constexpr double projection_flops = 37, projection_damping_flops = 10;
constexpr double keep_flops = 3;  // the position that the displacement leads to
constexpr double pin_flops = 9;
constexpr double wind_flops = 84;    // of one triangle, for one of its corners
constexpr double region_flops = 6;   // has the block left the region of its list of colliders?
constexpr double outrun_flops = 14;  // is it where the list of near pairs expects it?
constexpr double survey_flops = 16, reach_flops = 6, normal_flops = 23;
// Of the test alone: a particle that is inside pays 50 to 80 more.
constexpr struct {
  const char* name;
  double flops;
} shapes[collider_shapes] = {{"sphere", 9},    {"plane", 6}, {"capsule", 20},
                             {"cylinder", 24}, {"box", 21},  {"mesh", 25}};

struct Sums {
  uint64_t edges = 0;
  uint64_t in_hubs = 0;  ///< of the directed springs
  uint64_t particles = 0, springs = 0, dragged = 0, damped_springs = 0, pinned = 0;
  uint64_t with_part[part_count] = {};
  uint64_t blown = 0;    ///< particles
  double triangles = 0;  ///< corners of triangles, with the padding of sliced rows
  int64_t entries = 0;
};

Sums sum_of(const WorldShape& world, KernelKind kind) {
  Sums s;
  for (const ClothShape& c : world.cloths) {
    if (c.kind != kind) continue;
    s.particles += c.particles;
    s.springs += c.directed_springs;
    s.in_hubs += c.hub_springs;
    s.entries += c.row_entries - static_cast<int64_t>(c.hub_springs);
    s.edges += c.edges;
    for (int k = 0; k < part_count; ++k) {
      if (c.has(static_cast<Part>(k))) s.with_part[k] += c.particles;
    }
    if (c.drag) s.dragged += c.particles;
    if (c.spring_damping) s.damped_springs += c.directed_springs;
    if (c.triangles) {
      s.triangles += is_grid(kind) ? 6.0 * c.particles : static_cast<double>(c.triangle_entries);
      if (world.wind) s.blown += c.particles;
    }
    s.pinned += uint64_t(c.moving_pin_blocks) * block_size;
  }
  return s;
}

/// Of the sum of a particle, read by the pass that integrates.
double sum_bytes(Accumulation a, double scalar) {
  if (a == Accumulation::fixed64) return 2 * 24;
  return (a == Accumulation::atomic ? 2 : 1) * 3 * scalar;
}

const char* name_of(Accumulation a) { return to_string(static_cast<Accumulate>(a)); }

/// The springs of hubs: evaluated where the cloth gathers, added where it scatters.
void add_hub_pass(const WorldShape& world, Plan& plan) {
  if (counts_of(world).hub_chunks == 0) return;
  const auto scalar = static_cast<double>(world.scalar());
  double springs = 0, bytes = 0, flops = 0;
  for (const ClothShape& c : world.cloths) {
    const auto of_cloth = static_cast<double>(c.hub_springs);
    springs += of_cloth;
    bytes += of_cloth * (scatters(c.kind) ? 4 + 3 * scalar : 4 + scalar);
    if (c.kind == KernelKind::mesh_per_spring) bytes += of_cloth * scalar;
    flops += of_cloth * (scatters(c.kind) ? sum_flops : spring_flops);
  }
  plan.passes.push_back(
      {"hubs", "substep",
       String("hub_chunks") + (world.precision == Precision::float64 ? "_float64" : "_float32"),
       static_cast<uint64_t>(springs), bytes / springs, flops / springs});
}

/// What comes before the advance passes where cloths scatter or have vertices of very many springs.
/// Of the pass "springs", `count` is springs and the rest is per spring.
void add_spring_passes(const WorldShape& world, Plan& plan) {
  const auto scalar = static_cast<double>(world.scalar());
  Sums s;
  for (const KernelKind kind : {KernelKind::scatter_grid, KernelKind::scatter_mesh}) {
    const Sums of = sum_of(world, kind);
    s.particles += of.particles;
    s.springs += of.springs;
    s.damped_springs += of.damped_springs;
    s.entries += of.entries;
    s.edges += of.edges;
    s.in_hubs += of.in_hubs;
  }
  const String suffix = String(world.precision == Precision::float64 ? "_float64" : "_float32") +
                        " " + name_of(world.accumulation);
  if (s.edges > 0) {
    const bool damped = s.damped_springs > 0;
    const double springs = std::max(1.0, static_cast<double>(s.springs) / 2);
    // Ends, constants and the force; positions of the ends come from cache, sums to a cache.
    const double filled = static_cast<double>(s.edges) / springs;
    double bytes = (8 + 2 * scalar) * filled, flops = spring_flops;
    bytes += uses_atomics(world.accumulation) ? 6 * (scalar > 4 ? 8 : 4) : 3 * scalar * filled;
    if (uses_atomics(world.accumulation)) flops += 6;
    if (damped) flops += spring_damping_flops;
    if (damped && world.accumulation == Accumulation::native) bytes += 3 * scalar * filled;
    plan.passes.push_back({"springs", "substep",
                           "edge_forces" + suffix + (damped ? " +spring_damping" : ""),
                           s.springs / 2, bytes, flops});
  }
  add_hub_pass(world, plan);
  if (s.edges > 0 && is_measured(world.accumulation)) {
    const auto n = static_cast<double>(std::max<uint64_t>(1, s.particles));
    plan.passes.push_back({"sums", "substep", "sum_forces" + suffix, s.particles,
                           (4 + 3 * scalar) * static_cast<double>(s.entries) / n + 3 * scalar,
                           4 * sum_flops * static_cast<double>(s.springs - s.in_hubs) / n});
  }
}

/// XPBD: springs move their ends, colour by colour. `count` is springs and the rest is per spring.
void add_projection(const WorldShape& world, Plan& plan) {
  if (!world.projects) return;
  const auto scalar = static_cast<double>(world.scalar());
  uint64_t springs = 0;
  uint32_t colours = 0;
  double bytes = 0, flops = 0;
  for (const ClothShape& c : world.cloths) {
    const uint64_t own = c.directed_springs / 2 + c.ladder_springs;
    springs += own;
    colours = std::max(colours, c.colours);
    // Of both ends, in every colour: positions, displacements there and back, inverse masses.
    bytes += 20 * scalar * static_cast<double>(own) + sizeof(SpringBlock) * double(c.spring_blocks);
    bytes += (8 + 2 * scalar) * static_cast<double>(c.coloured_springs);
    flops += projection_flops * static_cast<double>(own);
    if (c.spring_damping) {
      flops += projection_damping_flops * static_cast<double>(c.directed_springs / 2);
    }
  }
  const double n = std::max(1.0, static_cast<double>(springs));
  plan.passes.push_back(
      {"springs", "substep",
       "project_springs" + String(world.precision == Precision::float64 ? "_float64" : "_float32") +
           " " + std::to_string(colours).c_str() + "_colours",
       springs, bytes / n, flops / n});
}

Pass advance_pass(const WorldShape& world, KernelKind kind) {
  const Sums s = sum_of(world, kind);
  const auto scalar = static_cast<double>(world.scalar());
  const auto n = static_cast<double>(s.particles > 0 ? s.particles : 1);
  double bytes = (world.position_form ? 9 : 12) * scalar + scalar;  // x, d, x', d'; inverse mass
  if (is_grid(kind)) {
    bytes += 5.0 / block_size;  // block tables; presence bits at the border only
  } else if (!scatters(kind) && !world.projects) {
    const double entry = 4 + scalar + (kind == KernelKind::mesh_per_spring ? scalar : 0);
    bytes += entry * static_cast<double>(s.entries) / n;
  }
  double flops = integrate_flops;
  if (scatters(kind)) {
    // Native: a force of each spring of the particle. Otherwise its sum, which atomics leave full.
    const bool native = world.accumulation == Accumulation::native;
    if (native) {
      bytes += (4 + 3 * scalar) * static_cast<double>(s.entries) / n;
      flops += sum_flops * static_cast<double>(s.springs - s.in_hubs + s.damped_springs) / n;
    } else {
      bytes += sum_bytes(world.accumulation, scalar);
    }
  } else {
    if (world.projects) {
      bytes += 12 * scalar;  // a second pass, behind the springs
      flops += keep_flops;
    } else {
      flops += spring_flops * static_cast<double>(s.springs - s.in_hubs) / n;
      flops += spring_damping_flops * static_cast<double>(s.damped_springs) / n;
    }
  }
  flops += drag_flops * static_cast<double>(s.dragged) / n;
  flops += pin_flops * static_cast<double>(s.pinned) / n;
  for (int k = 0; k < collider_shapes; ++k) flops += shapes[k].flops * world.colliders[k];
  if (counts_of(world).all_colliders > 0) flops += region_flops;
  if (s.blown > 0) {
    flops += wind_flops * s.triangles / n;
    if (!is_grid(kind)) bytes += 8 * s.triangles / n;
  }
  bytes += (6 * scalar + 4) * static_cast<double>(s.pinned) / n;

  String name = kernel_name(kind);
  name += world.precision == Precision::float64 ? "_float64" : "_float32";
  if (world.position_form) name += " position";
  for (int k = 0; k < part_count; ++k) {
    if (s.with_part[k] == 0) continue;
    const PartCost& part = world.parts[k];
    name += String(" +") + part.name;
    bytes += part.bytes * static_cast<double>(s.with_part[k]) / n;
    flops += part.flops * static_cast<double>(s.with_part[k]) / n;
  }
  if (s.blown > 0) name += " +wind";
  if (s.damped_springs > 0) name += " +spring_damping";
  if (s.dragged > 0) name += " +drag";
  if (world.contact_grids > 0) {
    name += " +contacts";
    if (!world.staggered) {
      bytes += 6 * scalar;
      flops += outrun_flops;
    }
  }
  for (int k = 0; k < collider_shapes; ++k) {
    if (world.colliders[k] > 0) name += String(" +") + shapes[k].name + "_colliders";
  }
  if (s.pinned > 0) name += " +moving_pins";
  return {"advance", "substep", name, s.particles, bytes, flops};
}

/// Partners that a particle of a layer on another one has, and those that the search looks at.
constexpr double usual_partners = 8, usual_candidates = 24;
/// Groups that a group of particles is watched with, and those of them that are looked into.
constexpr double usual_group_pairs = 24, usual_looks = 2;

/// Particles that meet each other: what finds them, which a complete search does for some substeps
/// at once, and what they do to each other where they are near.
void add_contact_passes(const WorldShape& world, uint64_t particles, Plan& plan) {
  if (world.contact_grids == 0) return;
  const auto s = static_cast<double>(world.scalar());
  const double grids = world.contact_grids, keys = (3 * s + 8 * grids), cells = 8;
  const String suffix = world.precision == Precision::float64 ? "_float64" : "_float32";
  const auto add = [&](const char* stage, const char* kernel, double bytes, double flops) {
    plan.passes.push_back({stage, "substep", kernel + suffix, particles, bytes, flops});
  };
  const double entries = 4 * usual_partners;
  if (world.staggered) {
    add("keys", "staggered_keys", keys, 12 * grids);
    add("sort", "sort_by_key", 64 * grids, 0);
    add("rows", "staggered_rows", 24 * grids + 3 * s + entries, 14 * usual_candidates);
  } else if (world.contact_groups) {
    // What a substep in which particles come near each other costs; pairs of groups last longer.
    const double group_pairs = usual_group_pairs / contact_group,
                 looks = usual_looks / contact_group;
    add("motions", "move_groups", 9 * s + (4 * s + 72) / contact_group, 40);
    add("boxes", "box_groups", 6 * s + 240.0 / contact_group, 30);
    add("pairs", "pair_groups", (72 + 16) * group_pairs, 40 * group_pairs);
    add("rows", "near_rows", (8 + 4 * s) * group_pairs + (8 + 24 * s) * looks + 4,
        14 * group_pairs + 64 * 9 * looks);
  } else {
    add("bounds", "contact_bounds", 18 * s, 40);
    add("keys", "cell_keys", keys, 12);
    add("sort", "sort_few_bits", 48, 0);
    add("cells", "sorted_cells", 8 + 13 * s + 4 + 4 * cells, 6);
    add("rows", "near_rows", 13 * s + 8 + entries, 24 * usual_candidates);
  }
  add("count", "count_touching", entries + 3 * s + 4, 9 * usual_partners);
  const double moves = world.position_form ? 15 + 12 : 18;
  add("push", "push_apart", contact_passes * (entries + 2 * s * usual_partners + 13 * s + 8),
      contact_passes * 66 * usual_partners);
  add("apply", "apply_pushes", contact_passes * moves * s, contact_passes * 6);
}

/// Passes over all particles, whatever their kind.
void add_other_passes(const WorldShape& world, Plan& plan) {
  const auto scalar = static_cast<double>(world.scalar());
  uint64_t particles = 0;
  double corners = 0;
  for (const ClothShape& c : world.cloths) {
    particles += c.particles;
    if (c.triangles) corners += is_grid(c.kind) ? 6.0 * c.particles : double(c.triangle_entries);
  }
  if (particles == 0) return;
  add_contact_passes(world, particles, plan);
  if (world.contact_grids > 0) {
    plan.passes.insert(plan.passes.begin(),
                       {"keep", "frame", "start_of_frame", particles, 12 * scalar, 0});
  }
  if (counts_of(world).all_colliders > 0) {
    const Pass reach{"reach",
                     "frame",
                     "near_colliders_of_blocks",
                     particles,
                     3 * scalar + sizeof(BlockReach<float>) / double(block_size),
                     reach_flops};
    plan.passes.insert(plan.passes.begin(), reach);
  }
  if (world.interpolate) {
    plan.passes.insert(plan.passes.begin(),
                       {"keep", "frame", "positions_before", particles, 6 * scalar, 0});
  }
  plan.passes.push_back(
      {"survey", "frame", "bounds_speed_and_loss", particles, 6 * scalar, survey_flops});
  if (world.normals) {
    plan.passes.push_back({"normals", "call", "vertex_normals", particles, 6 * scalar,
                           normal_flops * corners / static_cast<double>(particles)});
  }
}

}  // namespace

const char* kernel_name(KernelKind kind) {
  switch (kind) {
    case KernelKind::seed12:
      return "grid_seed12";
    case KernelKind::classic12:
      return "grid_classic12";
    case KernelKind::quad4:
      return "grid_quad4";
    case KernelKind::tri6:
      return "grid_tri6";
    case KernelKind::scatter_grid:
      return "scatter_grid";
    case KernelKind::scatter_mesh:
      return "scatter_mesh";
    case KernelKind::mesh_uniform:
      return "mesh_uniform";
    case KernelKind::mesh_per_spring:
      return "mesh_per_spring";
  }
  return "unknown";
}

Plan compile_plan(const WorldShape& world) {
  Plan plan;
  add_spring_passes(world, plan);
  int first = 0;
  for (const ClothShape& c : world.cloths) {
    const int blocks = static_cast<int>(c.blocks());
    if (plan.ranges.empty() || plan.ranges.back().kind != c.kind) {
      plan.ranges.push_back({c.kind, first, 0});
      plan.passes.push_back(advance_pass(world, c.kind));
    }
    plan.ranges.back().count += blocks;
    first += blocks;
  }
  add_projection(world, plan);
  add_other_passes(world, plan);
  return plan;
}

}  // namespace weft::plan
