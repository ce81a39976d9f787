#include "plan/layout.h"

#include <algorithm>

namespace weft::plan {

namespace {

/// Hands out offsets one after the other, each aligned to 128 bytes.
class Cutter {
 public:
  Cutter(size_t scalar, size_t step) : scalar_(scalar), step_(step) {}

  size_t take(size_t elements, size_t element_bytes) {
    const size_t at = bytes_;
    bytes_ = (bytes_ + std::max<size_t>(elements * element_bytes, 1) + 127) / 128 * 128;
    return at;
  }
  /// An array of vectors with `guard` elements before and behind.
  VectorArray take_vectors(size_t elements, size_t guard) {
    const size_t band = (guard + 31) / 32 * 32;
    const size_t whole = elements + 2 * band;
    if (step_ > 1) return {take(whole, step_ * scalar_) + band * step_ * scalar_, 1};
    // An odd number of lines from component to component: powers of two would share cache sets.
    const size_t pitch = (whole + 31) / 32 * 32 + (whole / 32 % 2 == 0 ? 32 : 64);
    return {take(3 * pitch, scalar_) + band * scalar_, pitch};
  }
  size_t bytes() const { return bytes_; }

 private:
  size_t scalar_, step_, bytes_ = 0;
};

template <class T>
size_t collider_bytes(int shape) {
  switch (static_cast<ColliderShape>(shape)) {
    case ColliderShape::sphere:
      return sizeof(Sphere<T>);
    case ColliderShape::plane:
      return sizeof(Plane<T>);
    case ColliderShape::capsule:
      return sizeof(Capsule<T>);
    case ColliderShape::cylinder:
      return sizeof(Cylinder<T>);
    case ColliderShape::box:
      return sizeof(Box<T>);
    case ColliderShape::mesh:
      return sizeof(MeshCollider<T>);
  }
  return 0;
}

/// The springs of the cloths that scatter, and where their forces go.
void lay_out_edges(const WorldShape& world, size_t scalar, Cutter& cut, EdgeLayout& l) {
  size_t edges = 0, entries = 0, blocks = 0;
  bool damped = false;
  for (const ClothShape& c : world.cloths) {
    if (!scatters(c.kind)) continue;
    edges += static_cast<size_t>(c.edges);
    entries += static_cast<size_t>(c.row_entries);
    blocks += c.blocks();
    damped |= c.spring_damping;
  }
  if (blocks == 0) return;
  const Accumulation mode = world.accumulation;
  l.cloth = cut.take(edges / block_size, sizeof(int32_t));
  l.a = cut.take(edges, sizeof(int32_t));
  l.b = cut.take(edges, sizeof(int32_t));
  l.rest = cut.take(edges, scalar);
  l.stiffness = cut.take(edges, scalar);
  if (!uses_atomics(mode)) {
    l.force = cut.take_vectors(edges, 0);
    if (damped && mode == Accumulation::native) l.damping = cut.take_vectors(edges, 0);
    l.start = cut.take(blocks + 1, sizeof(int64_t));
    l.incident = cut.take(entries, sizeof(int32_t));
  }
  if (mode == Accumulation::fixed64) {
    l.fixed = cut.take(3 * blocks * block_size, sizeof(unsigned long long));
    l.overflow = cut.take(1, sizeof(unsigned long long));
  } else if (mode != Accumulation::native) {
    l.total = cut.take_vectors(blocks * block_size, 0);
  }
  if (mode == Accumulation::fixed8) l.largest = cut.take(1, sizeof(unsigned long long));
}

/// Vertices of very many springs; atomics do not need to know them.
void lay_out_hubs(const WorldShape& world, size_t scalar, Cutter& cut, HubLayout& l) {
  size_t hubs = 0, chunks = 0;
  bool damped = false;
  for (const ClothShape& c : world.cloths) {
    hubs += c.hubs;
    chunks += c.hub_chunks;
    damped |= c.hubs > 0 && c.spring_damping;
  }
  if (hubs == 0) return;
  l.of_block = cut.take(world.blocks(), sizeof(int32_t));
  l.hub = cut.take(hubs, sizeof(Hub));
  l.chunk = cut.take(chunks, sizeof(HubChunk));
  l.force = cut.take(chunks, 3 * scalar);
  if (damped) l.damping = cut.take(chunks, 3 * scalar);
}

/// Colliders, who is near them, and who sleeps.
template <class T>
void lay_out_activity(const WorldShape& world, Cutter& cut, Layout& l) {
  const size_t cloths = world.cloths.size(), colliders = world.all_colliders();
  if (colliders > 0 || world.any_sleeper()) {
    l.activity = cut.take(cloths, sizeof(ClothActivity<T>));
  }
  if (colliders == 0) return;
  for (int shape = 0; shape < collider_shapes; ++shape) {
    const size_t count = cloths * world.colliders[shape];
    if (count > 0) l.colliders[shape] = cut.take(count, collider_bytes<T>(shape));
  }
  l.near = cut.take(cloths * colliders, sizeof(int32_t));
  l.near_reach = cut.take(cloths * colliders, sizeof(ReachOfCollider<T>));
  l.block_reach = cut.take(world.blocks(), sizeof(BlockReach<T>));
  if (world.turning_colliders > 0) {
    const size_t rows = size_t(world.substeps) + 1;
    l.turn = cut.take(rows * world.turning_colliders, sizeof(Mat3<T>));
  }
  if (!world.meshes.empty()) {
    l.near_memory = cut.take(world.blocks() * block_size, sizeof(NearMemory<T>));
  }
  for (const MeshArrays& m : world.meshes) {
    MeshArrays offsets{};
    for (int a = 0; a < MeshArrays::count; ++a) {
      offsets.of[a] = m.of[a] > 0 ? cut.take(m.of[a], 1) : absent;
    }
    l.meshes.push_back(offsets);
  }
}

}  // namespace

bool WorldShape::any_grid() const {
  return std::any_of(cloths.begin(), cloths.end(), [](auto& c) { return is_grid(c.kind); });
}
bool WorldShape::any_rows() const {
  return std::any_of(cloths.begin(), cloths.end(),
                     [](auto& c) { return !is_grid(c.kind) && !scatters(c.kind); });
}
bool WorldShape::any_mesh() const {
  return std::any_of(cloths.begin(), cloths.end(), [](auto& c) { return !is_grid(c.kind); });
}
bool WorldShape::any_scatter() const {
  return std::any_of(cloths.begin(), cloths.end(), [](auto& c) { return scatters(c.kind); });
}
uint32_t WorldShape::hubs() const {
  uint32_t sum = 0;
  for (const ClothShape& c : cloths) sum += c.hubs;
  return sum;
}
uint32_t WorldShape::hub_chunks() const {
  uint32_t sum = 0;
  for (const ClothShape& c : cloths) sum += c.hub_chunks;
  return sum;
}
bool WorldShape::any_per_spring() const {
  return std::any_of(cloths.begin(), cloths.end(),
                     [](auto& c) { return c.kind == KernelKind::mesh_per_spring; });
}
bool WorldShape::any_spring_damping() const {
  return std::any_of(cloths.begin(), cloths.end(), [](auto& c) { return c.spring_damping; });
}
bool WorldShape::reads_velocities() const {
  const bool blown = wind && std::any_of(cloths.begin(), cloths.end(),
                                         [](auto& c) { return c.triangles && c.particles > 0; });
  return blown || any_spring_damping();
}
bool WorldShape::any_triangle_rows() const {
  return (wind || normals) && std::any_of(cloths.begin(), cloths.end(),
                                          [](auto& c) { return c.triangles && !is_grid(c.kind); });
}
bool WorldShape::any_sleeper() const {
  return std::any_of(cloths.begin(), cloths.end(), [](auto& c) { return c.sleeps; });
}
uint32_t WorldShape::all_colliders() const {
  uint32_t sum = 0;
  for (const uint32_t count : colliders) sum += count;
  return sum;
}
uint32_t WorldShape::survey_groups() const {
  uint32_t sum = 0;
  for (const ClothShape& c : cloths) sum += (c.blocks() + survey_blocks - 1) / survey_blocks;
  return sum;
}
uint64_t WorldShape::moving_pin_blocks() const {
  uint64_t sum = 0;
  for (const ClothShape& c : cloths) sum += c.moving_pin_blocks;
  return sum;
}
uint64_t WorldShape::blocks() const {
  uint64_t sum = 0;
  for (const ClothShape& c : cloths) sum += c.blocks();
  return sum;
}

Layout lay_out(const WorldShape& world, int particle_step) {
  const bool wide = world.precision == Precision::float64;
  const size_t scalar = wide ? sizeof(double) : sizeof(float);
  Cutter cut(scalar, static_cast<size_t>(particle_step));
  const size_t blocks = world.blocks();
  const size_t particles = blocks * block_size;
  size_t guard = 0, row_blocks = 0, mesh_blocks = 0, entries = 0, own_stiffness = 0, forced = 0;
  for (const ClothShape& c : world.cloths) {
    guard = std::max(guard, static_cast<size_t>(c.guard));
    if (!is_grid(c.kind)) mesh_blocks += c.blocks();
    if (!is_grid(c.kind) && !scatters(c.kind)) {
      row_blocks += c.blocks();
      entries += static_cast<size_t>(c.row_entries);
    }
    if (c.kind == KernelKind::mesh_per_spring) own_stiffness = 1;
    if (c.constant_forces) forced += c.blocks();
  }

  Layout l;
  l.x[0] = cut.take_vectors(particles, guard);
  l.x[1] = cut.take_vectors(particles, guard);
  if (world.position_form) {
    l.x[2] = cut.take_vectors(particles, guard);
  } else {
    l.d[0] = cut.take_vectors(particles, guard);
    l.d[1] = world.reads_velocities() ? cut.take_vectors(particles, guard) : l.d[0];
  }
  if (world.interpolate) l.before = cut.take_vectors(particles, 0);
  l.inverse_mass = cut.take(particles, scalar);
  l.block_cloth = cut.take(blocks, sizeof(int32_t));
  l.cloths = cut.take(world.cloths.size(),
                      wide ? sizeof(ClothParams<double>) : sizeof(ClothParams<float>));
  if (world.any_grid()) {
    l.presence = cut.take(particles, sizeof(uint16_t));
    l.block_inner = cut.take(blocks, 1);
  }
  if (world.any_rows()) {
    l.slice_start = cut.take(row_blocks + 1, sizeof(int64_t));
    l.neighbour = cut.take(entries, sizeof(int32_t));
    l.rest = cut.take(entries, scalar);
    if (own_stiffness > 0) l.stiffness = cut.take(entries, scalar);
  }
  lay_out_edges(world, scalar, cut, l.edges);
  lay_out_hubs(world, scalar, cut, l.hubs);
  if (forced > 0) l.force = cut.take_vectors(forced * block_size, 0);
  if (world.any_triangle_rows()) {
    size_t triangles = 0;
    for (const ClothShape& c : world.cloths) triangles += static_cast<size_t>(c.triangle_entries);
    l.triangle_start = cut.take(mesh_blocks + 1, sizeof(int64_t));
    l.triangle_next = cut.take(triangles, sizeof(int32_t));
    l.triangle_last = cut.take(triangles, sizeof(int32_t));
  }
  if (wide) {
    lay_out_activity<double>(world, cut, l);
  } else {
    lay_out_activity<float>(world, cut, l);
  }
  if (const size_t pin_blocks = world.moving_pin_blocks(); pin_blocks > 0) {
    l.block_pins = cut.take(blocks, sizeof(int32_t));
    l.pin_base = cut.take_vectors(pin_blocks * block_size, 0);
    l.pin_glide = cut.take_vectors(pin_blocks * block_size, 0);
    l.pin_motion = cut.take(pin_blocks * block_size, sizeof(int32_t));
    l.pin_offset = cut.take(size_t(world.motions) * world.substeps, 3 * scalar);
  }
  l.survey_ranges = cut.take(world.survey_groups(), sizeof(SurveyRange));
  l.survey = cut.take(world.survey_groups(), wide ? sizeof(Survey<double>) : sizeof(Survey<float>));
  l.bytes = cut.bytes();
  return l;
}

}  // namespace weft::plan
