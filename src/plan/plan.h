// From a world's shape to the ordered passes it needs, with their cost.
#pragma once

#include <string>
#include <vector>

#include "plan/shape.h"

namespace weft::plan {

struct Pass {
  const char* stage;
  const char* per;  ///< "substep", "frame" or "call"
  std::string kernel;
  uint64_t count;             ///< particles
  double bytes_per_particle;  ///< through memory once; neighbours come from cache
  double flops_per_particle;
};

struct Plan {
  std::vector<Pass> passes;
  std::vector<BlockRange> ranges;  ///< of the advance passes, in arena order
};

Plan compile_plan(const WorldShape&);

const char* kernel_name(KernelKind);

}  // namespace weft::plan
