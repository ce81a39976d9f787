// How a world is evaluated: ways to add up the forces of springs, and the passes of a step.
#pragma once

#include "weft/core.hpp"

namespace weft {
inline namespace v0 {

/// How the forces of springs reach the vertices: Georgii and Westermann 2005, section 4.
enum class Evaluation : uint8_t {
  automatic,  ///< of each cloth the cheaper one, by the model that plan() reports
  gather,     ///< every vertex evaluates all of its springs, so that each is evaluated twice
  scatter     ///< every spring is evaluated once, and its force is added at both ends
};
/// How a scatter adds up the forces of a vertex. Only the first and `fixed64` are meant for use;
/// the others show what the precision of the sum does.
enum class Accumulate : uint8_t {
  native,       ///< over its springs in ascending neighbour index: the bits of the gather
  atomic,       ///< floating-point atomics, in an order that changes from run to run
  fixed64,      ///< 64-bit integer atomics: any order gives the same bits. A spring that pulls more
                ///< than 4096 times as much as at twice its length leaves the range: diverged
  float16,      ///< half floats, scaled by a power of two to the forces of the cloth
  float24,      ///< 17 significant bits, the fragment units of 2005; the rest as ever
  float24_all,  ///< the same for positions, displacements and all of the force
  fixed8        ///< 8 bits with a sign, saturating at `fixed8_range` times the largest spring force
};
WEFT_API const char* to_string(Evaluation) noexcept;
WEFT_API const char* to_string(Accumulate) noexcept;

/// One pass of the compiled plan, in the order it runs.
struct PassInfo {
  const char* stage;          ///< e.g. "advance"
  const char* per;            ///< "substep", "frame" or "call"
  const char* kernel;         ///< e.g. "grid_seed12_float32"
  uint64_t count;             ///< particles it touches; springs in the passes "springs" and "hubs"
  double bytes_per_particle;  ///< (or spring) moved once through memory, neighbours from cache
  double flops_per_particle;  ///< additions, multiplications, divisions and roots
};
/// How a cloth is evaluated, and what the model says of either way: ns of a substep on one thread,
/// without what both have in common.
struct EvaluationInfo {
  ClothId cloth;
  Evaluation chosen;  ///< gather or scatter
  double gather_ns, scatter_ns;
};
struct PlanInfo {
  View<PassInfo> passes;             ///< valid until the next call on the world
  View<EvaluationInfo> evaluations;  ///< by cloth, in the order of creation; valid as long
  uint64_t bytes_state;              ///< particles, springs and effects on the device
  uint64_t bytes_total;              ///< all that the library asks its allocator for
};

}  // namespace v0
}  // namespace weft
