#include "api/arena/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::api {

namespace {

template <class T>
void include(const Survey<T>& group, ClothRecord& cloth) {
  double3 &low = cloth.low, &high = cloth.high;
  low = {std::min(low.x, double(group.low.x)), std::min(low.y, double(group.low.y)),
         std::min(low.z, double(group.low.z))};
  high = {std::max(high.x, double(group.high.x)), std::max(high.y, double(group.high.y)),
          std::max(high.z, double(group.high.z))};
  cloth.furthest = std::max(cloth.furthest, std::sqrt(double(group.furthest2)));
  cloth.broken |= group.broken != 0;
}

}  // namespace

template <class T>
void take_survey(const ArenaInput& in, const Vector<Survey<T>>& groups) {
  const double far = std::numeric_limits<double>::infinity();
  for (ClothRecord* cloth : in.cloths) {
    cloth->low = {far, far, far};
    cloth->high = {-far, -far, -far};
    cloth->furthest = 0;
    cloth->broken = false;
    auto next = static_cast<size_t>(cloth->place.survey_groups);
    const uint32_t blocks = (cloth->cooked().vertices + block_size - 1) / block_size;
    for (uint32_t b = 0; b < blocks; b += survey_blocks) include(groups[next++], *cloth);
  }
}

template void take_survey(const ArenaInput&, const Vector<Survey<float>>&);
template void take_survey(const ArenaInput&, const Vector<Survey<double>>&);

}  // namespace weft::api
