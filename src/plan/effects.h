// What a world's cloths need, in numbers: all that a plan depends on.
#pragma once

#include <vector>

#include "state/simulation.h"
#include "weft/core.hpp"

namespace weft::plan {

/// One cloth, in arena order.
struct ClothShape {
  KernelKind kind;
  uint32_t particles;
  uint64_t directed_springs;
  int64_t row_entries;  ///< sliced rows, padding included; 0 for grids
  int guard;            ///< elements that the stencil reads before and behind
  bool constant_forces;
  bool drag;
  bool spring_damping;
  uint32_t moving_pin_blocks;
  uint32_t blocks() const { return (particles + block_size - 1) / block_size; }
};

struct WorldShape {
  Precision precision = Precision::float32;
  bool position_form = false;
  std::vector<ClothShape> cloths;
  uint32_t colliders[collider_shapes] = {};  ///< by ColliderShape
  uint32_t motions = 0;   ///< of all cloths, and one for "none" when any pin moves
  uint32_t substeps = 1;  ///< most in a frame: motions are tabulated

  uint32_t colliders_of(ColliderShape shape) const { return colliders[static_cast<int>(shape)]; }
  bool any_grid() const;
  bool any_rows() const;
  bool any_per_spring() const;
  bool any_spring_damping() const;
  uint64_t moving_pin_blocks() const;
  uint64_t blocks() const;
};

constexpr bool is_grid(KernelKind kind) { return kind <= KernelKind::tri6; }

}  // namespace weft::plan
