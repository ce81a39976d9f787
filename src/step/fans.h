// The triangles around the particles of each kind of cloth: two kinds for all kernels.
#pragma once

#include "kernels/fan.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
GridFan<T> fan_of(const Simulation<T>& sim, const GridFan<T>*) {
  return {sim.presence, sim.block.inner};
}
template <class T>
MeshFan<T> fan_of(const Simulation<T>& sim, const MeshFan<T>*) {
  return {sim.triangles};
}
/// Calls `launch` with the triangles around the particles of a kind of cloth.
template <class T, class Launch>
void with_fan(KernelKind kind, const Simulation<T>& sim, Launch launch) {
  if (kind <= KernelKind::scatter_grid) {
    return launch(GridFan<T>{sim.presence, sim.block.inner});
  }
  return launch(MeshFan<T>{sim.triangles});
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
