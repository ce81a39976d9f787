#include "api/records/evaluation.h"

#include <algorithm>
#include <cmath>

#include "api/context/vector_math.h"
#include "scene/each_spring.h"
#include "scene/edges.h"

namespace weft::api {

plan::EvaluationCost cost_of(const ClothRecord& cloth, Precision precision,
                             const BackendInfo& backend) {
  const scene::CookedFabric& fabric = cloth.cooked();
  plan::EvaluationShape shape{};
  shape.grid = fabric.is_grid;
  shape.edges = fabric.springs;
  shape.entries = fabric.is_grid ? 2 * fabric.springs : uint64_t(fabric.row_entries);
  return plan::evaluation_cost(shape, plan::prices_of(backend.isa, precision));
}

namespace {

/// Of one spring: its stiffness times the longest of its rest length and its lengths in the rest
/// shape and at the start.
void find_forces(ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  Vector<uint32_t> springs(fabric.vertices, 0);
  scene::each_spring(fabric, [&](uint32_t i, uint32_t j, double stiffness, double rest) {
    const double at_rest = length(minus(posed(cloth, i), posed(cloth, j)));
    const double at_start = length(minus(start_position(cloth, i), start_position(cloth, j)));
    const double longest = std::max({rest, at_rest, at_start});
    cloth.force_scale = std::max(cloth.force_scale, stiffness * longest);
    ++springs[i];
    ++springs[j];
  });
  for (const uint32_t count : springs) cloth.most_springs = std::max(cloth.most_springs, count);
}

}  // namespace

void choose_evaluation(const WorldDesc& desc, const BackendInfo& backend, ClothRecord& cloth) {
  if (desc.integrator == Integrator::xpbd) {
    cloth.scatters = false;
  } else if (desc.evaluation == Evaluation::automatic) {
    const plan::EvaluationCost cost = cost_of(cloth, desc.precision, backend);
    cloth.scatters = cost.scatter < cost.gather;
  } else {
    cloth.scatters = desc.evaluation == Evaluation::scatter;
  }
  if (desc.accumulate == Accumulate::fixed64 || desc.accumulate == Accumulate::float16) {
    find_forces(cloth);
  }
}

double power_of_two_above(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(1.0, std::clamp(fraction == 0.5 ? exponent - 1 : exponent, -60, 60));
}

FixedRange fixed_range(const ClothRecord& cloth) {
  const double limit = 4096 * power_of_two_above(cloth.force_scale);
  const double share = std::ldexp(1.0, 62) / power_of_two_above(cloth.most_springs);
  return {share / limit, limit};
}

double half_scale(const ClothRecord& cloth) {
  const double most = std::max(16.0, power_of_two_above(cloth.most_springs));
  return 32768 / most / power_of_two_above(cloth.force_scale);
}

}  // namespace weft::api
