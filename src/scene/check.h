// Checks of the values in descriptions, shared by all topologies. Each throws InvalidInput.
#pragma once

#include "scene/fabric.h"

namespace weft::scene {

/// Largest coordinate: squares of distances stay far from overflow in float.
constexpr double largest_coordinate = 1e9;
/// Largest of all other numbers, and the range of masses: products stay within float.
constexpr double largest_value = 1e18, smallest_mass = 1e-18;

void check_finite(double value, const char* field);
void check_not_negative(double value, const char* field);
void check_positive(double value, const char* field);
/// An enumerator must be one of the first `count`; `names` lists them.
void check_choice(int value, int count, const char* field, const char* names);
/// A view that has a count must have data.
void check_view(const void* data, uint64_t count, uint32_t stride, size_t element,
                const char* field);
template <class T>
void check_view(const View<T>& view, const char* field) {
  check_view(view.data, view.count, view.stride, sizeof(T), field);
}
/// Spring `index` of a fabric of so many vertices; `kind` is its word: "network".
void check_spring(const Spring&, uint32_t index, uint32_t vertices, const char* kind);
void check_material(const Material&, uint32_t vertices);
void check_positions(PointView, const char* field);
/// Copies positions, scaled.
void store_positions(PointView, double scale, CookedFabric&);
/// Fills `mass` or `masses`; by density, triangles must be known already.
void set_masses(const Mass&, CookedFabric&);

}  // namespace weft::scene
