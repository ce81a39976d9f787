#include "api/arena/arena_views.h"

namespace weft::api {

template <class T>
static Edges<T> edges_of(const plan::EdgeLayout& l, const plan::WorldShape& shape, char* base) {
  const auto at = [base](size_t offset) {
    return offset == plan::absent ? nullptr : base + offset;
  };
  const auto vectors = [&](const plan::VectorArray& a) {
    return Vec3Array<T>{reinterpret_cast<T*>(at(a.offset)), a.pitch};
  };
  Edges<T> e{};
  uint64_t count = 0;
  for (const plan::ClothShape& c : shape.cloths) count += c.edges;
  e.blocks = static_cast<int>(count / block_size);
  e.cloth = reinterpret_cast<const int32_t*>(at(l.cloth));
  e.a = reinterpret_cast<const int32_t*>(at(l.a));
  e.b = reinterpret_cast<const int32_t*>(at(l.b));
  e.rest = reinterpret_cast<const T*>(at(l.rest));
  e.stiffness = reinterpret_cast<const T*>(at(l.stiffness));
  e.force = vectors(l.force);
  e.damping = vectors(l.damping);
  e.start = reinterpret_cast<const int64_t*>(at(l.start));
  e.incident = reinterpret_cast<const int32_t*>(at(l.incident));
  e.accumulation = shape.accumulation;
  e.total = vectors(l.total);
  e.fixed = reinterpret_cast<unsigned long long*>(at(l.fixed));
  e.overflow = reinterpret_cast<unsigned long long*>(at(l.overflow));
  e.largest = reinterpret_cast<unsigned long long*>(at(l.largest));
  e.full_scale = shape.full_scale;
  return e;
}

template <class T>
Simulation<T> views_of(const plan::Layout& l, const plan::Plan& plan, const plan::WorldShape& shape,
                       char* base) {
  const auto at = [base](size_t offset) {
    return offset == plan::absent ? nullptr : base + offset;
  };
  const auto vectors = [&](const plan::VectorArray& a) {
    return Vec3Array<T>{reinterpret_cast<T*>(at(a.offset)), a.pitch};
  };
  Simulation<T> sim{};
  sim.blocks = static_cast<int>(shape.blocks());
  sim.cloths = reinterpret_cast<const ClothParams<T>*>(at(l.cloths));
  sim.block = {reinterpret_cast<const int32_t*>(at(l.block_cloth)),
               reinterpret_cast<const uint8_t*>(at(l.block_inner)),
               reinterpret_cast<const int32_t*>(at(l.block_pins))};
  sim.presence = reinterpret_cast<const uint16_t*>(at(l.presence));
  sim.inverse_mass = reinterpret_cast<const T*>(at(l.inverse_mass));
  sim.force = vectors(l.force);
  int mesh_block = 0, row_block = 0, scatter_block = 0, scatter_blocks = 0;
  for (const BlockRange& r : plan.ranges) {
    sim.ranges[sim.range_count++] = r;
    const int end = r.first + r.count;
    if (plan::is_grid(r.kind)) mesh_block = end;
    if (r.kind < KernelKind::scatter_grid) scatter_block = end;
    if (r.kind <= KernelKind::scatter_mesh) row_block = end;
    if (plan::scatters(r.kind)) scatter_blocks += r.count;
  }
  if (scatter_blocks > 0) {
    sim.edges = edges_of<T>(l.edges, shape, base);
    sim.edges.first_block = scatter_block;
    sim.edges.particle_blocks = scatter_blocks;
  }
  if (l.hubs.hub != plan::absent) {
    sim.hubs = {reinterpret_cast<const int32_t*>(at(l.hubs.of_block)),
                reinterpret_cast<const Hub*>(at(l.hubs.hub)),
                reinterpret_cast<const HubChunk*>(at(l.hubs.chunk)),
                reinterpret_cast<Vec3<T>*>(at(l.hubs.force)),
                reinterpret_cast<Vec3<T>*>(at(l.hubs.damping)),
                static_cast<int>(shape.hubs()),
                static_cast<int>(shape.hub_chunks())};
  }
  sim.rows = {reinterpret_cast<const int64_t*>(at(l.slice_start)),
              reinterpret_cast<const int32_t*>(at(l.neighbour)),
              reinterpret_cast<const T*>(at(l.rest)), reinterpret_cast<const T*>(at(l.stiffness)),
              row_block};
  sim.colliders = {reinterpret_cast<const Sphere<T>*>(at(l.colliders[0])),
                   reinterpret_cast<const Plane<T>*>(at(l.colliders[1])),
                   reinterpret_cast<const Capsule<T>*>(at(l.colliders[2])),
                   reinterpret_cast<const Cylinder<T>*>(at(l.colliders[3])),
                   reinterpret_cast<const Box<T>*>(at(l.colliders[4])),
                   reinterpret_cast<const MeshCollider<T>*>(at(l.colliders[5])),
                   reinterpret_cast<const Mat3<T>*>(at(l.turn)),
                   static_cast<int>(shape.turning_colliders),
                   reinterpret_cast<const int32_t*>(at(l.near)),
                   reinterpret_cast<const ReachOfCollider<T>*>(at(l.near_reach))};
  sim.activity = reinterpret_cast<const ClothActivity<T>*>(at(l.activity));
  sim.reach = reinterpret_cast<BlockReach<T>*>(at(l.block_reach));
  sim.near_memory = reinterpret_cast<NearMemory<T>*>(at(l.near_memory));
  sim.survey_ranges = reinterpret_cast<const SurveyRange*>(at(l.survey_ranges));
  sim.survey = reinterpret_cast<Survey<T>*>(at(l.survey));
  sim.survey_count = static_cast<int>(shape.survey_groups());
  sim.triangles = {reinterpret_cast<const int64_t*>(at(l.triangle_start)),
                   reinterpret_cast<const int32_t*>(at(l.triangle_next)),
                   reinterpret_cast<const int32_t*>(at(l.triangle_last)), mesh_block};
  sim.pins = {vectors(l.pin_base), vectors(l.pin_glide),
              reinterpret_cast<const int32_t*>(at(l.pin_motion)),
              reinterpret_cast<const Vec3<T>*>(at(l.pin_offset)), static_cast<int>(shape.motions)};
  for (int k = 0; k < 3; ++k) sim.x[k] = vectors(l.x[k]);
  for (int k = 0; k < 2; ++k) sim.d[k] = vectors(l.d[k]);
  return sim;
}

template Simulation<float> views_of(const plan::Layout&, const plan::Plan&, const plan::WorldShape&,
                                    char*);
template Simulation<double> views_of(const plan::Layout&, const plan::Plan&,
                                     const plan::WorldShape&, char*);

}  // namespace weft::api
