#include "step_bound.h"

#include "io/text_cursor.h"

#include <algorithm>
#include <cmath>

namespace weft::tools {

uint64_t fewest_substeps(double frame, double bound) {
  if (!std::isfinite(bound)) return 1;
  const double quotient = std::ceil(frame / bound);
  if (!(quotient < 1e15)) return uint64_t(1e15);  // no count that anyone could run
  auto count = uint64_t(std::max(quotient, 1.0));
  // The division may have rounded to either side; the comparison is the one that a step makes.
  if (frame / double(count) > bound) ++count;
  if (count > 1 && frame / double(count - 1) <= bound) --count;
  return count;
}

std::string worst_element(const io::Scene& scene, const io::RunningScene& made,
                          const Stability& stability) {
  const size_t cloth = made.index_of(stability.cloth);
  if (cloth == made.cloths.size()) return "no cloth";
  const std::string where = "cloth '" + scene.cloths[cloth].name + "', ";
  if (stability.a == stability.b) return where + "vertex " + std::to_string(stability.a);
  return where + "spring " + std::to_string(stability.a) + "-" + std::to_string(stability.b);
}

std::optional<std::string> beyond_bound(const io::Scene& scene, const io::RunningScene& made,
                                        const Stability& stability) {
  const uint32_t fixed = scene.time.substeps;
  if (fixed == 0) return std::nullopt;
  const double dt = scene.time.frame / fixed;
  if (dt <= stability.dt_bound) return std::nullopt;
  return std::to_string(fixed) + " is too few (the step of " + io::number_text(dt) +
         " s is beyond the stable bound of " + io::number_text(stability.dt_bound) + " s set by " +
         worst_element(scene, made, stability) + ") give at least " +
         std::to_string(fewest_substeps(scene.time.frame, stability.dt_bound)) +
         ", or \"auto\", or set solver.unsafe to true";
}

}  // namespace weft::tools
