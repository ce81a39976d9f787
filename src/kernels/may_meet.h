// Which particles contact concerns: by cloth, by layers, by how near they are at rest.
#pragma once

#include "state/contacts.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Whether particles i and j, which differ, of cloths `a` and `b` touch when they are near enough.
template <class T>
WEFT_HD bool may_meet(const Contacts<T>& c, int i, int j, int a, int b) {
  const ContactCloth &one = c.cloth[a], &other = c.cloth[b];
  if (a != b) {
    return ((one.others & other.others) != 0) & ((one.layers & other.layers) != 0);
  }
  const double* p = c.rest + 3 * int64_t(i);
  const double* q = c.rest + 3 * int64_t(j);
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  const bool excluded = (x * x + y * y) + z * z < one.distance * one.distance;
  return (one.itself != 0) & (!excluded | (c.with_excluded != 0));
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
