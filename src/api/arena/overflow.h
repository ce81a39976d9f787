// The first force that left the range of fixed64, as the device keeps it.
#pragma once

#include "api/arena/arena.h"

namespace weft::api {

template <class T>
Status find_overflow(const Backend& backend, const Edges<T>& edges, ForceOverflow& found) {
  found = {};
  if (!edges.overflow) return Status::ok;
  unsigned long long key = no_overflow;
  Status status = backend.to_host(&key, edges.overflow, sizeof key);
  if (status != Status::ok || key == no_overflow) return status;
  found.happened = true;
  found.substep = static_cast<int>(key >> 32);
  const auto e = static_cast<size_t>(key & 0xffffffffu);
  T stiffness{}, rest{};
  status = backend.to_host(&found.a, edges.a + e, sizeof found.a);
  if (status == Status::ok) status = backend.to_host(&found.b, edges.b + e, sizeof found.b);
  if (status == Status::ok) {
    status = backend.to_host(&stiffness, edges.stiffness + e, sizeof stiffness);
  }
  if (status == Status::ok) status = backend.to_host(&rest, edges.rest + e, sizeof rest);
  found.stiffness = static_cast<double>(stiffness);
  found.rest = static_cast<double>(rest);
  return status;
}

}  // namespace weft::api
