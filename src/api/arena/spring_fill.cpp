#include "api/arena/spring_fill.h"

#include <algorithm>
#include <cmath>

#include "api/arena/image.h"
#include "api/context/vector_math.h"
#include "scene/grid.h"

namespace weft::api {

namespace {

/// +column, +row, -column, -row by one, or none of them.
int axis_of(const scene::StencilOffset& o) {
  if (o.row == 0 && o.column == 1) return 0;
  if (o.row == 1 && o.column == 0) return 1;
  if (o.row == 0 && o.column == -1) return 2;
  return o.row == -1 && o.column == 0 ? 3 : -1;
}

/// In the expression of kernels/spring.h, so that a rest shape pulls nothing to the last bit.
template <class T>
T distance(const Vec3<T>& a, const Vec3<T>& b) {
  const T x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

template <class T>
void fill_grid_constants(const scene::CookedFabric& fabric, ClothParams<T>& p) {
  const scene::CookedGrid& grid = fabric.grid;
  const scene::StencilTable& table = scene::stencil_table(grid.stencil);
  // A single row has nothing above or below: its loads may stay where they are.
  p.columns = grid.rows > 1 ? static_cast<int>(grid.columns) : 0;
  for (int k = 0; k < table.count; ++k) {
    const scene::StencilOffset o = table.offset[k];
    p.stiffness[k] = static_cast<T>(scene::stencil_stiffness(o, fabric.stiffness));
    const int axis = axis_of(o);
    if (axis >= 0) p.axial[axis] = 1 << k;
    const T x = static_cast<T>(o.column * grid.column_spacing);
    const T y = static_cast<T>(o.row * grid.row_spacing);
    p.rest[k] =
        fabric.rest_length >= 0 ? static_cast<T>(fabric.rest_length) : std::sqrt(x * x + y * y);
  }
}

template <class T>
SpringFiller<T>::SpringFiller(const ArenaInput& in, Simulation<T>& image)
    : image_(image), counts_(plan::counts_of(in.shape)) {
  if (image.hubs.of_block) {
    std::fill_n(writable(image.hubs.of_block), counts_.particles / block_size,
                static_cast<int32_t>(counts_.hubs));
  }
  if (image.edges.overflow) *image.edges.overflow = no_overflow;
}

template <class T>
void SpringFiller<T>::fill(const ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  if (fabric.is_grid) {
    if (cloth.scatters) fill_edges(cloth);
    return;
  }
  rest_shape_.resize(fabric.vertices);
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    rest_shape_[v] = narrow<T>(minus(posed(cloth, v), cloth.rest_origin));
  }
  if (cloth.scatters) {
    fill_edges(cloth);
  } else {
    fill_rows(cloth);
  }
  if (image_.coloured.projects != 0) fill_coloured(cloth);
}

/// Of entry k of the row of vertex v.
template <class T>
T SpringFiller<T>::rest_of(const ClothRecord& cloth, uint32_t v, uint64_t k) const {
  const scene::CookedFabric& fabric = cloth.cooked();
  const double given = fabric.rows.rest.empty() ? fabric.rest_length : fabric.rows.rest[k];
  if (given >= 0) return static_cast<T>(given);
  return distance(rest_shape_[v], rest_shape_[fabric.rows.neighbour[k]]);
}

template <class T>
T SpringFiller<T>::stiffness_of(const ClothRecord& cloth, uint64_t k) const {
  const scene::CookedFabric& fabric = cloth.cooked();
  return static_cast<T>(fabric.rows.stiffness.empty() ? fabric.stiffness.stretch
                                                      : fabric.rows.stiffness[k]);
}

template <class T>
void SpringFiller<T>::fill_entry(const ClothRecord& cloth, int64_t e, uint32_t v, uint64_t k) {
  const scene::CookedFabric& fabric = cloth.cooked();
  writable(image_.rows.neighbour)[e] =
      cloth.first() + static_cast<int32_t>(fabric.storage_of[fabric.rows.neighbour[k]]);
  writable(image_.rows.rest)[e] = rest_of(cloth, v, k);
  if (image_.rows.stiffness) writable(image_.rows.stiffness)[e] = stiffness_of(cloth, k);
}

template <class T>
void SpringFiller<T>::fill_rows(const ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  const scene::SpringRows& rows = fabric.rows;
  const int64_t entry = cloth.place.row_entries;
  int64_t* start = writable(image_.rows.start) + cloth.place.row_slices;
  int32_t* neighbour = writable(image_.rows.neighbour);
  const int slices = slices_of(cloth);
  for (int s = 0; s <= slices; ++s) start[s] = entry + fabric.slice_start[size_t(s)];
  const int64_t hubs_at =
      counts_.row_entries + cloth.place.hub_entries - fabric.slice_start[size_t(slices)];
  size_t hub = 0;
  for (int self = 0; self < slices * block_size; ++self) {
    const int slice = self / block_size;
    int64_t e = start[slice] + self % block_size, stride = block_size, end = start[slice + 1];
    if (hub < fabric.hubs.size() && int(fabric.hubs[hub].storage) == self) {
      for (; e < end; e += stride) neighbour[e] = cloth.first() + self;  // its row in the slice
      const scene::HubRow& row = fabric.hubs[hub++];
      e = hubs_at + row.first;
      stride = 1;
      end = e + (int64_t(row.count) + block_size - 1) / block_size * block_size;
    }
    if (self < static_cast<int>(fabric.vertices)) {
      const uint32_t v = fabric.caller_of[size_t(self)];
      for (uint64_t k = rows.start[v]; k < rows.start[size_t(v) + 1]; ++k, e += stride) {
        fill_entry(cloth, e, v, k);
      }
    }
    for (; e < end; e += stride) neighbour[e] = cloth.first() + self;
  }
  fill_hubs(cloth, hubs_at);
}

template <class T>
void SpringFiller<T>::fill_hubs(const ClothRecord& cloth, int64_t at) {
  auto next_hub = static_cast<int32_t>(cloth.place.hubs);
  auto next_chunk = static_cast<int32_t>(cloth.place.hub_chunks);
  for (const scene::HubRow& row : cloth.cooked().hubs) {
    const int32_t particle = cloth.first() + static_cast<int32_t>(row.storage);
    int32_t& of_block = writable(image_.hubs.of_block)[particle / block_size];
    of_block = std::min(of_block, next_hub);
    const int64_t first = at + row.first;
    const int64_t end = first + (int64_t(row.count) + block_size - 1) / block_size * block_size;
    Hub& hub = writable(image_.hubs.hub)[next_hub++];
    hub = {particle, next_chunk, next_chunk};
    for (int64_t e = first; e < end; e += hub_chunk) {
      writable(image_.hubs.chunk)[next_chunk++] = {e, std::min(end, e + hub_chunk), particle};
    }
    hub.end_chunk = next_chunk;
  }
}

template <class T>
void SpringFiller<T>::fill_edges(const ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  const scene::Edges table = scene::build_edges(fabric);
  ClothParams<T> grid{};
  if (fabric.is_grid) fill_grid_constants(fabric, grid);
  const int64_t first = cloth.place.edges;
  int32_t* a = writable(image_.edges.a) + first;
  int32_t* b = writable(image_.edges.b) + first;
  T* rest = writable(image_.edges.rest) + first;
  T* stiffness = writable(image_.edges.stiffness) + first;
  const uint64_t room = scene::padded_edges(table.edges.size());
  for (size_t e = 0; e < room; ++e) {
    a[e] = b[e] = cloth.first();
    if (e >= table.edges.size()) continue;
    const scene::Edge& edge = table.edges[e];
    a[e] += static_cast<int32_t>(edge.a);
    b[e] += static_cast<int32_t>(edge.b);
    rest[e] = fabric.is_grid ? grid.rest[edge.entry]
                             : rest_of(cloth, fabric.caller_of[edge.a], edge.entry);
    stiffness[e] = fabric.is_grid ? grid.stiffness[edge.entry] : stiffness_of(cloth, edge.entry);
  }
  std::fill_n(writable(image_.edges.cloth) + first / block_size, room / block_size,
              static_cast<int32_t>(cloth.place.cloths));
  if (image_.edges.start) fill_incident(cloth, table);
}

/// Meshes and networks: colour by colour.
template <class T>
void SpringFiller<T>::fill_coloured(const ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  int64_t at = cloth.place.coloured_springs;
  for (const scene::Edge& edge : cloth.colours->springs) {
    writable(image_.coloured.a)[at] = cloth.first() + static_cast<int32_t>(edge.a);
    writable(image_.coloured.b)[at] = cloth.first() + static_cast<int32_t>(edge.b);
    if (edge.a != edge.b) {
      writable(image_.coloured.rest)[at] = rest_of(cloth, fabric.caller_of[edge.a], edge.entry);
      writable(image_.coloured.stiffness)[at] = stiffness_of(cloth, edge.entry);
    }
    ++at;
  }
}

template <class T>
void SpringFiller<T>::fill_incident(const ClothRecord& cloth, const scene::Edges& table) {
  const int slices = slices_of(cloth);
  const int64_t first = cloth.place.incident;
  int64_t* start = writable(image_.edges.start) + cloth.place.scatter_slices;
  for (int s = 0; s <= slices; ++s) start[s] = first + table.slice_start[size_t(s)];
  int32_t* incident = writable(image_.edges.incident);
  const int64_t sliced = table.slice_start[size_t(slices)];
  const int64_t hubs_at = counts_.incident + cloth.place.hub_incident - sliced;
  const auto shift = static_cast<int32_t>(cloth.place.edges);
  for (size_t e = 0; e < table.incident.size(); ++e) {
    const int32_t i = table.incident[e];
    const int64_t at =
        static_cast<int64_t>(e) + (static_cast<int64_t>(e) < sliced ? first : hubs_at);
    incident[at] = i < 0 ? i - shift : i + shift;
  }
  fill_hubs(cloth, hubs_at);
}

template void fill_grid_constants(const scene::CookedFabric&, ClothParams<float>&);
template void fill_grid_constants(const scene::CookedFabric&, ClothParams<double>&);
template class SpringFiller<float>;
template class SpringFiller<double>;

}  // namespace weft::api
