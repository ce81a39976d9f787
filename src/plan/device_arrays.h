// The device memory of a world: what kernels see, and what the host keeps beside it.
#pragma once

#include "base/memory_host.h"
#include "plan/cutter.h"
#include "plan/shape.h"

namespace weft::plan {

template <class T>
struct DeviceArrays {
  Simulation<T> sim{};
  Vec3Array<T> before{};                ///< positions before the last frame
  Vector<TriangleGrid<T>> meshes;  ///< in the order of WorldShape::meshes
  size_t bytes = 0;
};

/// Cuts memory at `base`, or only counts the bytes where that is null.
template <class T>
DeviceArrays<T> cut(const WorldShape& world, int vector_stride, char* base) {
  const Counts counts = counts_of(world);
  Cutter cutter(base, static_cast<size_t>(vector_stride));
  DeviceArrays<T> arrays;
  cutter.group(arrays.sim, counts);
  cutter(arrays.before, counts.keeps_before ? counts.particles : 0);
  for (const GridCounts& mesh : world.meshes) {
    cutter.group(arrays.meshes.emplace_back(), mesh);
  }
  arrays.bytes = cutter.bytes();
  return arrays;
}

/// What a world takes on a device.
inline size_t device_bytes(const WorldShape& world, int vector_stride) {
  return world.precision == Precision::float64 ? cut<double>(world, vector_stride, nullptr).bytes
                                               : cut<float>(world, vector_stride, nullptr).bytes;
}

}  // namespace weft::plan
