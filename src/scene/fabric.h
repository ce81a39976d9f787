// What cooking makes of a description: checked, ordered, ready to be uploaded. Host data in caller
// order, in double, so that one fabric serves every precision and pose.
#pragma once

#include <memory_resource>
#include <string>

#include "base/memory_host.h"
#include "base/portability.h"
#include "weft/fabric.hpp"

namespace weft::scene {

template <class T>
using Array = std::pmr::vector<T>;

/// A regular grid; its springs are nowhere stored.
struct CookedGrid {
  uint32_t rows = 0, columns = 0;
  double row_spacing = 0, column_spacing = 0;  ///< m, scaled
  Stencil stencil = Stencil::seed12;
};

/// Springs of a mesh or network by vertex: compressed rows, neighbours ascending, both directions.
struct SpringRows {
  explicit SpringRows(std::pmr::memory_resource* memory)
      : start(memory), neighbour(memory), stiffness(memory), rest(memory) {}
  Array<uint64_t> start;      ///< vertices + 1
  Array<uint32_t> neighbour;  ///< two entries per spring
  Array<double> stiffness;    ///< per entry; empty: the same for all
  Array<double> rest;         ///< per entry, negative: initial; empty: the fabric's for all
};

/// A vertex whose springs do not fit into a slice (state/springs.h): `count` entries from `first`
/// on, filled up to whole blocks.
struct HubRow {
  uint32_t storage;
  int64_t first;
  uint32_t count;
};

struct CookedDiagnostic {
  Severity severity;
  uint32_t element;
  String text;
};

struct CookedFabric {
  explicit CookedFabric(std::pmr::memory_resource* memory)
      : positions(memory),
        triangles(memory),
        masses(memory),
        rows(memory),
        caller_of(memory),
        storage_of(memory),
        slice_start(memory),
        hubs(memory),
        particle_of(memory),
        storage_of_render(memory) {}

  bool is_grid = false;
  uint32_t vertices = 0;
  uint64_t springs = 0;  ///< unique, undirected
  Stiffness stiffness;   ///< by class; of meshes with one stiffness for all: stretch
  double rest_length = initial_rest_length;
  double mass = 0;  ///< kg per vertex, where `masses` is empty

  CookedGrid grid;
  Array<double3> positions;   ///< rest shape, scaled; empty for grids
  Array<uint32_t> triangles;  ///< 3 each; empty for grids
  Array<double> masses;       ///< kg; empty: all equal
  SpringRows rows;

  // Storage order of meshes and networks; empty for grids, whose order is the caller's.
  Array<uint32_t> caller_of;   ///< by storage index
  Array<uint32_t> storage_of;  ///< by caller index
  Array<int64_t> slice_start;  ///< per slice of 32 and one more: first entry of the sliced rows
  Array<HubRow> hubs;          ///< ascending storage index; their entries lie behind the slices
  int64_t row_entries = 0;     ///< of slices and hubs, padding included

  // Of welded meshes, by vertex as it was given; else empty.
  Array<uint32_t> particle_of;
  Array<uint32_t> storage_of_render;

  Vector<CookedDiagnostic> diagnostics;

  uint32_t render_vertices() const {
    return particle_of.empty() ? vertices : static_cast<uint32_t>(particle_of.size());
  }
  /// Storage index by vertex as it was given; null: the same.
  const uint32_t* render_storage() const {
    if (is_grid) return nullptr;
    return particle_of.empty() ? storage_of.data() : storage_of_render.data();
  }
  double mass_of(uint32_t v) const { return masses.empty() ? mass : masses[v]; }
  double3 position_of(uint32_t v) const {
    if (!is_grid) return positions[v];
    return {double(v % grid.columns) * grid.column_spacing,
            double(v / grid.columns) * grid.row_spacing, 0};
  }
  uint32_t storage(uint32_t v) const { return is_grid ? v : storage_of[v]; }
};

void cook_grid(const GridDesc&, CookedFabric&);
void cook_mesh(const MeshDesc&, CookedFabric&);
void cook_network(const NetworkDesc&, CookedFabric&);

uint64_t triangle_count(const CookedFabric&);
/// Vertices of triangle t.
void triangle(const CookedFabric&, uint64_t t, uint32_t* out);

}  // namespace weft::scene
