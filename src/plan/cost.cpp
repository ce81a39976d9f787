#include "plan/cost.h"

#include <cstring>

namespace weft::plan {

EvaluationPrices prices_of(const char* isa, Precision precision) {
  const bool wide = precision == Precision::float64;
  if (std::strcmp(isa, "v4") == 0) {
    return wide ? EvaluationPrices{1.3, 1.65, 3.1, 1.15} : EvaluationPrices{0.4, 1.4, 2.7, 1.5};
  }
  if (std::strcmp(isa, "v3") == 0) {
    return wide ? EvaluationPrices{1.8, 2.1, 4.3, 1.6} : EvaluationPrices{0.55, 1.35, 2.9, 1.2};
  }
  if (std::strcmp(isa, "v2") == 0) {
    return wide ? EvaluationPrices{2.2, 2.35, 3.3, 1.4} : EvaluationPrices{1.0, 1.8, 2.7, 1.1};
  }
  // A GPU: bytes that go through memory at 2 TB/s.
  const double scalar = wide ? 8 : 4, ns_per_byte = 1 / 2000.0;
  return {0, (4 + scalar) * ns_per_byte, (8 + 2 * scalar + 3 * scalar) * ns_per_byte,
          (4 + 3 * scalar) * ns_per_byte};
}

EvaluationCost evaluation_cost(const EvaluationShape& shape, const EvaluationPrices& price) {
  const auto edges = static_cast<double>(shape.edges), entries = static_cast<double>(shape.entries);
  const double scatter = edges * price.edge + entries * price.incident;
  if (shape.grid) return {2 * edges * price.grid_spring, scatter};
  return {entries * price.mesh_spring, scatter};
}

}  // namespace weft::plan
