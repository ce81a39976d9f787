// A cooked collider mesh as a world keeps it on the device, in the world's scalar.
#pragma once

#include "plan/shape.h"
#include "scene/collider_mesh.h"

namespace weft::api {

/// What its arrays hold.
GridCounts grid_counts(const scene::CookedColliderMesh&);
/// Fills the arrays of an image, narrowed to T.
template <class T>
void fill_grid(const scene::CookedColliderMesh&, const TriangleGrid<T>& image);
/// Sets what is not an array.
template <class T>
void set_numbers(const scene::CookedColliderMesh&, TriangleGrid<T>& grid);

}  // namespace weft::api
