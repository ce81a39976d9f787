#include "step/backend.h"

namespace weft {

Backend::~Backend() = default;

}  // namespace weft
