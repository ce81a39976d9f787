// What a world remembers of an output, and the checks of its description.
#pragma once

#include "base/memory_host.h"
#include "weft/world.hpp"

namespace weft::api {

struct OutputRecord {
  OutputId id;  ///< null: the slot is free
  ClothId cloth;
  OutputDesc desc;
  Vector<float3> last;  ///< what was written before, where an attribute wants it
  bool has_last = false;
};

/// Throws InvalidInput; `vertices` of the cloth.
void check_output(const OutputDesc&, uint32_t vertices);
/// Whether the buffer is there and large enough; throws InvalidInput.
void check_memory(const OutputDesc&, uint32_t vertices);

inline bool is_wanted(const Attribute& a) { return a.format != Format::none; }

}  // namespace weft::api
