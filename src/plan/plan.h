// From a world's shape to the ordered passes it needs, with their cost.
#pragma once


#include "base/memory_host.h"
#include "plan/shape.h"

namespace weft::plan {

struct Pass {
  const char* stage;
  const char* per;  ///< "substep", "frame" or "call"
  String kernel;
  uint64_t count;             ///< particles
  double bytes_per_particle;  ///< through memory once; neighbours come from cache
  double flops_per_particle;
};

struct Plan {
  Vector<Pass> passes;
  Vector<BlockRange> ranges;  ///< of the advance passes, in arena order
};

Plan compile_plan(const WorldShape&);

/// Entries that the list of near pairs has room for at first; it grows with the pairs.
int64_t first_list_entries(const WorldShape&);
/// Bytes of an entry: the other particle, and what the pair has given in a substep.
uint64_t list_entry_bytes(const WorldShape&);

const char* kernel_name(KernelKind);

}  // namespace weft::plan
