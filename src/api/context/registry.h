// The back ends of this build. The only place that asks which optional ones there are.
#pragma once

#include "base/message_host.h"
#include "step/backend.h"
#include "weft/context.hpp"

namespace weft::api {

struct BackendChoice {
  const Backend* backend = nullptr;
  Text refusal;   ///< why there is none
  Text fallback;  ///< why a GPU of this build is not used
};
BackendChoice choose_backend(BackendKind, Isa);

}  // namespace weft::api
