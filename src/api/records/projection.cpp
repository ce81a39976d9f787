#include "api/records/projection.h"

#include <algorithm>
#include <cmath>

#include "api/context/vector_math.h"
#include "base/message_host.h"
#include "scene/colours.h"
#include "scene/each_spring.h"

namespace weft::api {

namespace {

double pull_of(const WorldDesc& desc) {
  const double g = length(desc.gravity);
  return g > 0 ? g : 9.81;
}

/// Whether a grid that hangs by a side hardly stretches under its own weight. Long springs take the
/// stiffness of the others as many times again as there are strides: soft cloth would sag less.
bool is_stiff(const scene::CookedFabric& fabric, double g) {
  constexpr double hardly = 0.005;  // of a spring at the top
  double mass = 0;
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    const double m = fabric.mass_of(v);
    mass += std::isinf(m) ? 0 : m;
  }
  const scene::CookedGrid& grid = fabric.grid;
  const double pull = fabric.stiffness.stretch * hardly;
  return g * mass <= pull * std::min(double(grid.columns) * grid.row_spacing,
                                     double(grid.rows) * grid.column_spacing);
}

scene::Ladder ladder_of(const WorldDesc& desc, const scene::CookedFabric& fabric) {
  scene::Ladder ladder;
  if (!fabric.is_grid) return ladder;
  if (desc.ladder[0] == automatic_ladder) {
    return is_stiff(fabric, pull_of(desc)) ? scene::usual_ladder(fabric) : ladder;
  }
  static_assert(sizeof ladder.stride >= sizeof desc.ladder);
  std::copy(std::begin(desc.ladder), std::end(desc.ladder), ladder.stride);
  return ladder;
}

/// 1/m: length by the square of that of a spring, of the chains that a cloth is made of.
double chain_of(const scene::CookedFabric& fabric) {
  if (fabric.vertices == 0 || fabric.springs == 0) return 0;
  if (fabric.is_grid) {
    const scene::CookedGrid& g = fabric.grid;
    const double along = g.columns > 1 ? (g.columns - 1) / g.column_spacing : 0;
    return std::max(along, g.rows > 1 ? (g.rows - 1) / g.row_spacing : 0);
  }
  double3 low = fabric.position_of(0), high = low;
  for (uint32_t v = 1; v < fabric.vertices; ++v) {
    const double3 x = fabric.position_of(v);
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  // A spring that begins far from its rest length is as long as the longer of the two.
  double sum = 0;
  scene::each_spring(fabric, [&](uint32_t i, uint32_t j, double, double rest) {
    sum += std::max(rest, length(minus(fabric.position_of(j), fabric.position_of(i))));
  });
  const double spring = sum / double(fabric.springs);
  const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  return spring > 0 ? extent / (spring * spring) : 0;
}

}  // namespace

void choose_colours(const WorldDesc& desc, ClothRecord& cloth) {
  if (desc.integrator != Integrator::xpbd) return;
  const scene::CookedFabric& fabric = cloth.cooked();
  auto colours =
      std::make_shared<scene::Colours>(scene::colour_springs(fabric, ladder_of(desc, fabric)));
  if (colours->valence > 0) {
    throw InvalidInput(
        text("vertex %u has %u springs (xpbd moves them one after the other, %u at most) remove "
             "springs, or let verlet integrate",
             colours->most_at, colours->valence, scene::most_colours / 2));
  }
  cloth.colours = std::move(colours);
  cloth.chain = chain_of(fabric);
}

double usual_substep(const WorldDesc& desc, const ClothRecord& cloth) {
  if (!(cloth.chain > 0)) return INFINITY;
  // Measured on sheets of 48 to 512 squared that swing down (`weft bench stretch`): twice what they
  // would need, for sheets that hang from a few vertices or lie on something.
  constexpr double one_pass = 0.026;       // g h^2 n^2/L without long springs
  constexpr double by_the_longest = 0.35;  // of its stride to the power of 3/4: steps are longer
  const double stride = cloth.colours->longest;
  const double longer = std::max(1.0, by_the_longest * std::sqrt(stride * std::sqrt(stride)));
  return longer * std::sqrt(one_pass / (pull_of(desc) * cloth.chain));
}

}  // namespace weft::api
