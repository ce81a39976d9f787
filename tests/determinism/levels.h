// The instruction sets that this build has and this processor knows.
#pragma once

#include "weft/weft.hpp"

#include <stdexcept>
#include <vector>

namespace weft_tests {

inline std::vector<weft::Isa> levels() {
  std::vector<weft::Isa> found;
  for (const weft::Isa isa : {weft::Isa::v2, weft::Isa::v3, weft::Isa::v4}) {
    weft::ContextDesc desc;
    desc.backend = weft::BackendKind::omp;
    desc.isa = isa;
    const weft::Status status = weft::Context::create(desc).status();
    if (status == weft::Status::ok) found.push_back(isa);
    if (status != weft::Status::ok && status != weft::Status::no_device) {
      throw std::runtime_error(weft::to_string(status));
    }
  }
  return found;
}
inline const char* name(weft::Isa isa) {
  const char* const names[] = {"auto", "v2", "v3", "v4"};
  return names[int(isa)];
}

}  // namespace weft_tests
