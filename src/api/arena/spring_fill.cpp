#include "api/arena/spring_fill.h"

#include <algorithm>
#include <cmath>

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
  const scene::GridShape& grid = fabric.grid;
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
SpringFiller<T>::SpringFiller(const ArenaInput& in, const plan::Layout& layout, char* image)
    : in_(in), layout_(layout), image_(image) {
  if (int32_t* first = array<int32_t>(layout.hubs.of_block)) {
    std::fill(first, first + in.shape.blocks(), static_cast<int32_t>(in.shape.hubs()));
  }
  if (auto* overflow = array<unsigned long long>(layout.edges.overflow)) *overflow = no_overflow;
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
    rest_shape_[v] = narrow<T>(minus(posed(cloth, v), cloth.origin));
  }
  if (cloth.scatters) {
    fill_edges(cloth);
  } else {
    fill_rows(cloth);
  }
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
  array<int32_t>(layout_.neighbour)[e] =
      cloth.first + static_cast<int32_t>(fabric.storage_of[fabric.rows.neighbour[k]]);
  array<T>(layout_.rest)[e] = rest_of(cloth, v, k);
  if (T* stiffness = array<T>(layout_.stiffness)) stiffness[e] = stiffness_of(cloth, k);
}

template <class T>
void SpringFiller<T>::fill_rows(const ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  const scene::SpringRows& rows = fabric.rows;
  int64_t* start = array<int64_t>(layout_.slice_start) + slice_;
  int32_t* neighbour = array<int32_t>(layout_.neighbour);
  const int slices = slices_of(cloth);
  for (int s = 0; s <= slices; ++s) start[s] = entry_ + fabric.slice_start[size_t(s)];
  size_t hub = 0;
  for (int self = 0; self < slices * block_size; ++self) {
    const int slice = self / block_size;
    int64_t e = start[slice] + self % block_size, step = block_size, end = start[slice + 1];
    if (hub < fabric.hubs.size() && int(fabric.hubs[hub].storage) == self) {
      for (; e < end; e += step) neighbour[e] = cloth.first + self;  // its row in the slice
      const scene::HubRow& row = fabric.hubs[hub++];
      e = entry_ + row.first;
      step = 1;
      end = e + (int64_t(row.count) + block_size - 1) / block_size * block_size;
    }
    if (self < static_cast<int>(fabric.vertices)) {
      const uint32_t v = fabric.caller_of[size_t(self)];
      for (uint64_t k = rows.start[v]; k < rows.start[size_t(v) + 1]; ++k, e += step) {
        fill_entry(cloth, e, v, k);
      }
    }
    for (; e < end; e += step) neighbour[e] = cloth.first + self;
  }
  fill_hubs(cloth, entry_);
  slice_ += slices;
  entry_ += fabric.row_entries;
}

template <class T>
void SpringFiller<T>::fill_hubs(const ClothRecord& cloth, int64_t first_entry) {
  for (const scene::HubRow& row : cloth.cooked().hubs) {
    const int32_t particle = cloth.first + static_cast<int32_t>(row.storage);
    int32_t& of_block = array<int32_t>(layout_.hubs.of_block)[particle / block_size];
    of_block = std::min(of_block, hub_);
    const int64_t first = first_entry + row.first;
    const int64_t end = first + (int64_t(row.count) + block_size - 1) / block_size * block_size;
    Hub& hub = array<Hub>(layout_.hubs.hub)[hub_++];
    hub = {particle, chunk_, chunk_};
    for (int64_t e = first; e < end; e += hub_chunk) {
      array<HubChunk>(layout_.hubs.chunk)[chunk_++] = {e, std::min(end, e + hub_chunk), particle};
    }
    hub.end_chunk = chunk_;
  }
}

template <class T>
void SpringFiller<T>::fill_edges(const ClothRecord& cloth) {
  const scene::CookedFabric& fabric = cloth.cooked();
  const scene::Edges table = scene::build_edges(fabric);
  ClothParams<T> grid{};
  if (fabric.is_grid) fill_grid_constants(fabric, grid);
  int32_t* a = array<int32_t>(layout_.edges.a) + edge_;
  int32_t* b = array<int32_t>(layout_.edges.b) + edge_;
  T* rest = array<T>(layout_.edges.rest) + edge_;
  T* stiffness = array<T>(layout_.edges.stiffness) + edge_;
  const uint64_t room = scene::padded_edges(table.edges.size());
  for (size_t e = 0; e < room; ++e) {
    a[e] = b[e] = cloth.first;
    if (e >= table.edges.size()) continue;
    const scene::Edge& edge = table.edges[e];
    a[e] += static_cast<int32_t>(edge.a);
    b[e] += static_cast<int32_t>(edge.b);
    rest[e] = fabric.is_grid ? grid.rest[edge.entry]
                             : rest_of(cloth, fabric.caller_of[edge.a], edge.entry);
    stiffness[e] = fabric.is_grid ? grid.stiffness[edge.entry] : stiffness_of(cloth, edge.entry);
  }
  int32_t* of_block = array<int32_t>(layout_.edges.cloth) + edge_ / block_size;
  std::fill(of_block, of_block + room / block_size, cloth.params);
  if (layout_.edges.incident != plan::absent) fill_incident(cloth, table);
  edge_ += static_cast<int64_t>(room);
}

template <class T>
void SpringFiller<T>::fill_incident(const ClothRecord& cloth, const scene::Edges& table) {
  const int slices = slices_of(cloth);
  int64_t* start = array<int64_t>(layout_.edges.start) + scatter_slice_;
  for (int s = 0; s <= slices; ++s) start[s] = incident_ + table.slice_start[size_t(s)];
  int32_t* incident = array<int32_t>(layout_.edges.incident) + incident_;
  const auto shift = static_cast<int32_t>(edge_);
  for (size_t e = 0; e < table.incident.size(); ++e) {
    const int32_t i = table.incident[e];
    incident[e] = i < 0 ? i - shift : i + shift;
  }
  fill_hubs(cloth, incident_);
  scatter_slice_ += slices;
  incident_ += static_cast<int64_t>(table.incident.size());
}

template void fill_grid_constants(const scene::CookedFabric&, ClothParams<float>&);
template void fill_grid_constants(const scene::CookedFabric&, ClothParams<double>&);
template class SpringFiller<float>;
template class SpringFiller<double>;

}  // namespace weft::api
