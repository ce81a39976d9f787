// Origins that follow their cloths between frames.
#pragma once

#include "api/arena/arena.h"
#include "api/arena/image.h"
#include "api/arena/survey.h"
#include "api/context/vector_math.h"

namespace weft::api {

/// As the positions are rounded.
template <class T>
double3 seen_from(const double3& origin, const double3& x) {
  const double3 now = minus(x, origin);
  return sizeof(T) == sizeof(float) ? rounded_to_float(now) : now;  // not by narrow: see there
}

/// Takes the origins of cloths that have left theirs along; `positions` are all arrays that hold
/// any. Inexact would only be a position that the shift makes larger: a stray's.
template <class T, size_t Count>
Status follow_cloths(const Backend& backend, const ArenaInput& in,
                     const Vec3Array<T> (&positions)[Count], Workers workers) {
  const int stride = backend.info().vector_stride;
  for (ClothRecord* cloth : in.cloths) {
    const double3 by = way_of_origin(*cloth);
    if (same(by, {0, 0, 0})) continue;
    const auto particles = static_cast<int>(cloth->cooked().vertices);
    for (const Vec3Array<T>& all : positions) {
      if (!all.data) continue;
      const Vec3Array<T> own{all.data + int64_t(cloth->first()) * stride, all.pitch};
      const Status status = backend.shift(OriginJob<T>{particles, own, narrow<T>(by)}, workers);
      if (status != Status::ok) return status;
    }
    cloth->settling = substeps_to_settle;
    cloth->origin = plus(cloth->origin, by);
    cloth->low = seen_from<T>(by, cloth->low);
    cloth->high = seen_from<T>(by, cloth->high);
    cloth->middle = minus(cloth->middle, by);
  }
  return Status::ok;
}

}  // namespace weft::api
