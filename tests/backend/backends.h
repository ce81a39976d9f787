// Every back end that can run here: the host's at each level of this processor, the host's with
// another memory layout, and a GPU.
#pragma once

#include <string>
#include <vector>

#include "step/backend.h"

namespace weft::testing {

struct NamedBackend {
  std::string name;
  const Backend* backend;
};
const std::vector<NamedBackend>& backends();

}  // namespace weft::testing
