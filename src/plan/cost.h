// What gathering and scattering cost, as a model of measured prices.
#pragma once

#include <cstdint>

#include "weft/core.hpp"

namespace weft::plan {

/// Of one cloth.
struct EvaluationShape {
  bool grid;
  uint64_t edges;
  uint64_t entries;  ///< of the rows of a gather or of the springs of each vertex, padding included
};

/// ns on one thread, of one of each, with all that belongs to it.
struct EvaluationPrices {
  double grid_spring;  ///< gathered, from a constant distance
  double mesh_spring;  ///< gathered, through an index
  double edge;         ///< a spring evaluated once and its force stored
  double incident;     ///< a stored force read and added
};

/// ns of a substep on one thread, without what both have in common.
struct EvaluationCost {
  double gather, scatter;
};

/// Measured by `weft bench forces` for each instruction level; a GPU's are in proportion to bytes.
EvaluationPrices prices_of(const char* isa, Precision);
EvaluationCost evaluation_cost(const EvaluationShape&, const EvaluationPrices&);

}  // namespace weft::plan
