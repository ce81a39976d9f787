#include "api/records/projection.h"

#include <algorithm>
#include <cmath>

#include "api/context/vector_math.h"
#include "base/message_host.h"
#include "scene/colours.h"
#include "scene/each_spring.h"

namespace weft::api {

namespace {

scene::Ladder ladder_of(const WorldDesc& desc, const scene::CookedFabric& fabric) {
  if (desc.ladder[0] == automatic_ladder) return scene::usual_ladder(fabric);
  scene::Ladder ladder;
  static_assert(sizeof ladder.stride >= sizeof desc.ladder);
  std::copy(std::begin(desc.ladder), std::end(desc.ladder), ladder.stride);
  return ladder;
}

/// m: the length of the longest side of the box around the rest shape, and of a mean spring.
struct Size {
  double extent = 0, spring = 0;
};
Size size_of(const scene::CookedFabric& fabric) {
  double3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    const double3 x = fabric.position_of(v);
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  Size size;
  size.extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  if (fabric.is_grid) {
    const scene::CookedGrid& g = fabric.grid;
    size.spring = std::min(g.columns > 1 ? g.column_spacing : INFINITY,
                           g.rows > 1 ? g.row_spacing : INFINITY);
    return size;
  }
  double sum = 0;
  scene::each_spring(fabric, [&](uint32_t i, uint32_t j, double, double rest) {
    sum += rest >= 0 ? rest : length(minus(fabric.position_of(j), fabric.position_of(i)));
  });
  size.spring = fabric.springs > 0 ? sum / double(fabric.springs) : 0;
  return size;
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
  const Size size = size_of(fabric);
  cloth.chain = size.extent > 0 && size.spring > 0 ? size.extent / (size.spring * size.spring) : 0;
}

double usual_substep(const WorldDesc& desc, const ClothRecord& cloth) {
  if (!(cloth.chain > 0)) return INFINITY;
  // Measured on sheets of 48 to 512 squared that swing down (`weft bench stretch`): twice what they
  // would need, for sheets that hang from a few vertices or lie on something.
  constexpr double one_pass = 0.026;       // g h^2 n^2/L without long springs
  constexpr double by_the_longest = 0.35;  // of its stride to the power of 3/4: steps are longer
  const double given = length(desc.gravity), g = given > 0 ? given : 9.81;
  const double stride = cloth.colours->longest;
  const double longer = std::max(1.0, by_the_longest * std::sqrt(stride * std::sqrt(stride)));
  return longer * std::sqrt(one_pass / (g * cloth.chain));
}

}  // namespace weft::api
