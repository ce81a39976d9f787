#include "backends.h"

#include "api/context/registry.h"

namespace weft {

const Backend& backend_omp_aos4();

namespace testing {

const std::vector<NamedBackend>& backends() {
  static const std::vector<NamedBackend> all = [] {
    std::vector<NamedBackend> found{{"omp_aos4", &backend_omp_aos4()}};
    const std::pair<const char*, Isa> levels[] = {
        {"omp_v2", Isa::v2}, {"omp_v3", Isa::v3}, {"omp_v4", Isa::v4}};
    for (const auto& [name, level] : levels) {
      const api::BackendChoice choice = api::choose_backend(BackendKind::omp, level);
      if (choice.backend) found.push_back({name, choice.backend});
    }
    const api::BackendChoice gpu = api::choose_backend(BackendKind::cuda, Isa::automatic);
    if (gpu.backend) found.push_back({"cuda", gpu.backend});
    return found;
  }();
  return all;
}

}  // namespace testing
}  // namespace weft
