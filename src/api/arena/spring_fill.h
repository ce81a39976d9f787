// Springs of all cloths in the image of the device memory: the constants of grids, rows, hubs, and
// the springs of cloths that scatter.
#pragma once

#include "api/arena/arena.h"
#include "base/memory_host.h"
#include "scene/edges.h"

namespace weft::api {

/// Stiffness and rest length by stencil neighbour.
template <class T>
void fill_grid_constants(const scene::CookedFabric&, ClothParams<T>&);

/// To be called for every cloth.
template <class T>
class SpringFiller {
 public:
  SpringFiller(const ArenaInput& in, Simulation<T>& image);
  void fill(const ClothRecord&);

 private:
  void fill_rows(const ClothRecord&);
  void fill_entry(const ClothRecord&, int64_t e, uint32_t v, uint64_t k);
  /// `at`: where the entry 0 of its fabric would be for the entries of hubs.
  void fill_hubs(const ClothRecord&, int64_t at);
  void fill_edges(const ClothRecord&);
  void fill_coloured(const ClothRecord&);
  void fill_incident(const ClothRecord&, const scene::Edges&);
  T rest_of(const ClothRecord&, uint32_t v, uint64_t k) const;
  T stiffness_of(const ClothRecord&, uint64_t k) const;

  Simulation<T>& image_;
  Counts counts_;
  Vector<Vec3<T>> rest_shape_;  ///< of the present cloth
};

}  // namespace weft::api
