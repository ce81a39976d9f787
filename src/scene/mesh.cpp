#include <algorithm>
#include <cmath>

#include "base/message_host.h"
#include "base/stable_sort_host.h"
#include "scene/check.h"
#include "scene/faces.h"
#include "scene/rows.h"
#include "scene/weld.h"

namespace weft::scene {

namespace {

/// An edge of a triangle with the vertex opposite to it.
struct TriangleSide {
  uint32_t a, b, opposite;  // a < b
  friend bool operator<(const TriangleSide& x, const TriangleSide& y) {
    return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.opposite < y.opposite;
  }
};

void check_triangles(const MeshDesc& desc) {
  check_view(desc.indices, "indices");
  if (desc.indices.count % 3 != 0) {
    throw InvalidInput(text("indices has %u elements (three make a triangle) give a multiple of 3",
                            desc.indices.count));
  }
  for (uint32_t i = 0; i < desc.indices.count; ++i) {
    if (desc.indices[i] >= desc.positions.count) {
      throw InvalidInput(
          text("triangle %u names vertex %u (the mesh has %u) give an index below that", i / 3,
               desc.indices[i], desc.positions.count));
    }
  }
  for (uint32_t t = 0; t < desc.indices.count / 3; ++t) {
    const uint32_t a = desc.indices[3 * t], b = desc.indices[3 * t + 1],
                   c = desc.indices[3 * t + 2];
    if (a == b || b == c || a == c) {
      throw InvalidInput(
          text("triangle %u is (%u, %u, %u) (a triangle has three different vertices) "
               "remove it or mend its indices",
               t, a, b, c));
    }
  }
}

Vector<TriangleSide> sorted_sides(const MeshDesc& desc) {
  Vector<TriangleSide> sides;
  sides.reserve(desc.indices.count);
  for (uint32_t t = 0; t < desc.indices.count / 3; ++t) {
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t a = desc.indices[3 * t + c], b = desc.indices[3 * t + (c + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), desc.indices[3 * t + (c + 2) % 3]});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Adds `bend` springs to the sorted stretch springs; where both exist the stretch spring stays.
void merge_bend(Vector<SpringRecord>& springs, Vector<SpringRecord>& bend, CookedFabric& fabric) {
  const auto before = [](const SpringRecord& x, const SpringRecord& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  };
  const auto same = [](const SpringRecord& x, const SpringRecord& y) {
    return x.a == y.a && x.b == y.b;
  };
  const size_t whole = springs.size() + bend.size();
  springs.insert(springs.end(), bend.begin(), bend.end());
  weft::stable_sort(springs.begin(), springs.end(), before);
  springs.erase(std::unique(springs.begin(), springs.end(), same), springs.end());
  if (springs.size() < whole) {
    fabric.diagnostics.push_back(
        {Severity::info, 0,
         text("%zu bend springs join vertices that a spring joins already and are left out",
              whole - springs.size())});
  }
}

/// Adds the springs beside the edges to the sorted springs of edges.
void merge_springs(const MeshDesc& desc, Vector<SpringRecord>& springs, CookedFabric& fabric) {
  struct Given {
    SpringRecord spring;
    uint32_t number;  ///< 0 for edges, then from 1
  };
  Vector<Given> all;
  all.reserve(springs.size() + desc.springs.count);
  for (const SpringRecord& s : springs) all.push_back({s, 0});
  for (uint32_t i = 0; i < desc.springs.count; ++i) {
    const Spring& s = desc.springs[i];
    all.push_back({{std::min(s.a, s.b), std::max(s.a, s.b), s.stiffness, s.rest_length}, i + 1});
  }
  weft::stable_sort(all.begin(), all.end(), [](const Given& x, const Given& y) {
    return x.spring.a != y.spring.a ? x.spring.a < y.spring.a : x.spring.b < y.spring.b;
  });
  springs.clear();
  uint32_t repeats = 0;
  const Given* first = nullptr;
  for (const Given& given : all) {
    if (!springs.empty() && springs.back().a == given.spring.a &&
        springs.back().b == given.spring.b) {
      if (repeats++ == 0 || given.number < first->number) first = &given;
      continue;
    }
    springs.push_back(given.spring);
  }
  if (repeats == 0) return;
  fabric.diagnostics.push_back(
      {Severity::warning, first->number - 1,
       text("%u springs join two vertices that an edge or a spring joins already, the first is %u, "
            "of vertices %u and %u (each is merged with the one before it) remove them",
            repeats, first->number - 1, first->spring.a, first->spring.b)});
}

/// Masses by density come with a message of their own.
void tell_of_loose_vertices(const MeshDesc& desc, CookedFabric& fabric) {
  Vector<bool> held(fabric.vertices, false);
  for (const uint32_t v : fabric.triangles) held[v] = true;
  for (uint32_t s = 0; s < desc.springs.count; ++s) {
    held[desc.springs[s].a] = held[desc.springs[s].b] = true;
  }
  const auto loose = std::count(held.begin(), held.end(), false);
  if (loose == 0) return;
  const auto first =
      static_cast<uint32_t>(std::find(held.begin(), held.end(), false) - held.begin());
  fabric.diagnostics.push_back(
      {Severity::warning, first,
       text("%u vertices belong to no triangle%s, the first is %u (nothing holds them: each moves "
            "on its own) take them out of the mesh",
            static_cast<uint32_t>(loose), desc.springs.count > 0 ? " and no spring" : "", first)});
}

/// As at the poles of a globe that was written point by point.
void tell_of_springs_without_length(const MeshDesc& desc, const Vector<SpringRecord>& springs,
                                    CookedFabric& fabric) {
  const auto length = [&](const SpringRecord& s) {
    const double3 a = desc.positions[s.a], b = desc.positions[s.b];
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  };
  double longest = 0;
  for (const SpringRecord& spring : springs) longest = std::max(longest, length(spring));
  const auto has_none = [&](const SpringRecord& s) { return length(s) <= 1e-9 * longest; };
  const auto first = std::find_if(springs.begin(), springs.end(), has_none);
  if (first == springs.end()) return;
  fabric.diagnostics.push_back(
      {Severity::warning, first->a,
       text("%u springs have no length to speak of, the first between the vertices %u and %u (they "
            "lie in one place) give both the same index, or a weld_distance",
            static_cast<uint32_t>(std::count_if(first, springs.end(), has_none)), first->a,
            first->b)});
}

/// The triangles, each once. `given`: their numbers as the caller knows them; empty: the same.
Vector<uint32_t> distinct_triangles(const MeshDesc& desc, const Vector<uint32_t>& given,
                                    CookedFabric& fabric) {
  Vector<uint32_t> corners(desc.indices.count);
  for (uint32_t i = 0; i < desc.indices.count; ++i) corners[i] = desc.indices[i];
  const Faces faces = distinct_faces(corners);
  Vector<uint32_t> kept;
  kept.reserve(3 * faces.kept.size());
  for (size_t k = 0; k < faces.kept.size(); ++k) {
    const uint32_t* v = &corners[3 * size_t(faces.kept[k])];
    const bool turned = faces.is_turned(k);
    kept.insert(kept.end(), {v[0], v[turned ? 2 : 1], v[turned ? 1 : 2]});
  }
  const auto number = [&](uint32_t t) { return given.empty() ? t : given[t]; };
  fabric.diagnostics.push_back(
      {Severity::warning, number(faces.first_repeat),
       text(
           "%u triangles are given again, the first is %u, which is triangle %u (each counts once) "
           "remove the copies",
           faces.repeats, number(faces.first_repeat), number(faces.its_like))});
  return kept;
}

bool has_repeats(const Vector<TriangleSide>& sides) {
  const auto same = [](const TriangleSide& x, const TriangleSide& y) {
    return x.a == y.a && x.b == y.b && x.opposite == y.opposite;
  };
  return std::adjacent_find(sides.begin(), sides.end(), same) != sides.end();
}

void cook_checked(const MeshDesc& mesh, const Vector<uint32_t>& given, CookedFabric& fabric) {
  MeshDesc desc = mesh;
  Vector<TriangleSide> sides = sorted_sides(desc);
  Vector<uint32_t> distinct;
  if (has_repeats(sides)) {
    distinct = distinct_triangles(desc, given, fabric);
    desc.indices = distinct;
    sides = sorted_sides(desc);
  }
  store_positions(desc.positions, desc.material.scale, fabric);
  fabric.stiffness = desc.material.stiffness;
  fabric.rest_length = desc.material.rest_length;
  fabric.triangles.resize(desc.indices.count);
  for (uint32_t i = 0; i < desc.indices.count; ++i) fabric.triangles[i] = desc.indices[i];

  Vector<SpringRecord> springs, bend;
  for (size_t first = 0; first < sides.size();) {
    size_t end = first + 1;
    while (end < sides.size() && sides[end].a == sides[first].a && sides[end].b == sides[first].b) {
      ++end;
    }
    springs.push_back({sides[first].a, sides[first].b, -1, -1});
    const uint32_t c = sides[first].opposite, d = sides[end - 1].opposite;
    if (desc.bend && end - first == 2 && c != d) {
      bend.push_back({std::min(c, d), std::max(c, d), desc.material.stiffness.bend, -1});
    }
    first = end;
  }
  if (desc.springs.count > 0) merge_springs(desc, springs, fabric);
  if (desc.bend) merge_bend(springs, bend, fabric);
  if (!(fabric.rest_length >= 0)) tell_of_springs_without_length(desc, springs, fabric);
  const uint32_t pieces = build_rows(springs, fabric);
  if (pieces > 1) {
    fabric.diagnostics.push_back(
        {Severity::info, 0,
         text("the mesh is %u pieces that no spring joins (each moves on its own) give vertices "
              "that belong together the same index, or a weld_distance",
              pieces)});
  }
  if (desc.material.mass.kind != Mass::Kind::density) tell_of_loose_vertices(desc, fabric);
  set_masses(desc.material.mass, fabric);
}

}  // namespace

void cook_mesh(const MeshDesc& desc, CookedFabric& fabric) {
  check_positions(desc.positions, "positions");
  check_triangles(desc);
  check_material(desc.material, desc.positions.count);
  check_not_negative(desc.weld_distance, "weld_distance");
  check_view(desc.springs, "springs");
  for (uint32_t i = 0; i < desc.springs.count; ++i) {
    check_spring(desc.springs[i], i, desc.positions.count, "mesh");
  }
  if (desc.weld_distance == 0) return cook_checked(desc, {}, fabric);
  const Welded welded = weld(desc);
  cook_checked(welded.mesh, welded.given, fabric);
  if (welded.dropped > 0) {
    fabric.diagnostics.push_back(
        {Severity::warning, 0,
         text("%u triangles lost a corner to welding and are left out", welded.dropped)});
  }
  if (welded.dropped_springs > 0) {
    fabric.diagnostics.push_back(
        {Severity::warning, 0,
         text("%u springs lost an end to welding and are left out", welded.dropped_springs)});
  }
  fabric.particle_of.assign(welded.particle_of.begin(), welded.particle_of.end());
  for (const uint32_t p : welded.particle_of) {
    fabric.storage_of_render.push_back(fabric.storage_of[p]);
  }
}

}  // namespace weft::scene
