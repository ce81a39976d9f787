// Springs of all cloths in the image of the device memory: the constants of grids, rows, hubs, and
// the springs of cloths that scatter.
#pragma once

#include "api/arena/arena.h"
#include "api/arena/fill.h"
#include "scene/edges.h"

namespace weft::api {

/// Stiffness and rest length by stencil neighbour.
template <class T>
void fill_grid_constants(const scene::CookedFabric&, ClothParams<T>&);

/// To be called for the cloths in arena order, whose `first` is known.
template <class T>
class SpringFiller {
 public:
  SpringFiller(const ArenaInput& in, const plan::Layout& layout, char* image);
  void fill(const ClothRecord&);

 private:
  template <class E>
  E* array(size_t offset) const {
    return offset == plan::absent ? nullptr : reinterpret_cast<E*>(image_ + offset);
  }
  void fill_rows(const ClothRecord&);
  void fill_entry(const ClothRecord&, int64_t e, uint32_t v, uint64_t k);
  void fill_hubs(const ClothRecord&, int64_t first_entry);
  void fill_edges(const ClothRecord&);
  void fill_incident(const ClothRecord&, const scene::Edges&);
  T rest_of(const ClothRecord&, uint32_t v, uint64_t k) const;
  T stiffness_of(const ClothRecord&, uint64_t k) const;

  const ArenaInput& in_;
  const plan::Layout& layout_;
  char* image_;
  std::vector<Vec3<T>> rest_shape_;  ///< of the present cloth
  int slice_ = 0, scatter_slice_ = 0, hub_ = 0, chunk_ = 0;
  int64_t entry_ = 0, incident_ = 0, edge_ = 0;
};

}  // namespace weft::api
