// From a list of springs to sorted rows, and their storage order.
#pragma once

#include "base/memory_host.h"
#include "scene/fabric.h"

namespace weft::scene {

/// Values below 0 mean: the fabric's own.
struct SpringRecord {
  uint32_t a, b;
  double stiffness, rest;
};

/// Fills rows, the spring count, and the storage order. Springs must be unique and have a < b.
/// Returns how many pieces the springs join the vertices to, those without a spring left out.
uint32_t build_rows(const Vector<SpringRecord>& springs, CookedFabric&);

/// Breadth-first order of the vertices, sorted by valence in windows of 1024, and the sliced rows'
/// extents. Neighbours in a row stay in ascending caller index: no sum depends on the order.
/// Returns the pieces.
uint32_t order_rows(CookedFabric&);

}  // namespace weft::scene
