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

/// The median of a sample, which a few strays do not move. `component` of every sample.
template <class T>
double median(const Survey<T>* groups, int count, T Vec3<T>::*component) {
  constexpr int most = 320;
  T values[most];
  const int step = (count * survey_samples + most - 1) / most;  // of very large cloths not all
  int n = 0;
  for (int s = 0; s < count * survey_samples && n < most; s += step) {
    values[n++] = groups[s / survey_samples].sample[s % survey_samples].*component;
  }
  if (n == 0) return 0;
  std::nth_element(values, values + n / 2, values + n);
  return values[n / 2];
}

double whole_way(double middle, double extent) {
  return std::fabs(middle) > 2 * extent + 0.5 ? std::nearbyint(middle) : 0;
}

}  // namespace

double3 way_of_origin(const ClothRecord& cloth) {
  if (cloth.broken) return {0, 0, 0};
  const double3& m = cloth.middle;
  return {whole_way(m.x, cloth.extent), whole_way(m.y, cloth.extent), whole_way(m.z, cloth.extent)};
}

template <class T>
void take_survey(const ArenaInput& in, const Vector<Survey<T>>& groups) {
  const double far = std::numeric_limits<double>::infinity();
  for (ClothRecord* cloth : in.cloths) {
    cloth->low = {far, far, far};
    cloth->high = {-far, -far, -far};
    cloth->furthest = 0;
    cloth->broken = false;
    auto next = static_cast<size_t>(cloth->place.survey_groups);
    const size_t first = next;
    const uint32_t blocks = (cloth->cooked().vertices + block_size - 1) / block_size;
    for (uint32_t b = 0; b < blocks; b += survey_blocks) include(groups[next++], *cloth);
    const Survey<T>* of = groups.data() + first;
    const int count = static_cast<int>(next - first);
    cloth->middle = {0, 0, 0};
    if (cloth->broken) continue;  // NaN has no order
    cloth->middle = {median(of, count, &Vec3<T>::x), median(of, count, &Vec3<T>::y),
                     median(of, count, &Vec3<T>::z)};
  }
}

template void take_survey(const ArenaInput&, const Vector<Survey<float>>&);
template void take_survey(const ArenaInput&, const Vector<Survey<double>>&);

}  // namespace weft::api
