#include "scene/check.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "base/message_host.h"

namespace weft::scene {

void check_finite(double value, const char* field) {
  if (!std::isfinite(value)) {
    throw InvalidInput(
        text("%s is %g (it must be a finite number) give a finite value", field, value));
  }
  if (std::fabs(value) > largest_value) {
    throw InvalidInput(text("%s is %g (numbers reach to 1e18) give a smaller one", field, value));
  }
}
void check_not_negative(double value, const char* field) {
  check_finite(value, field);
  if (value < 0) {
    throw InvalidInput(text("%s is %g (it must not be negative) give a value >= 0", field, value));
  }
}
void check_positive(double value, const char* field) {
  check_finite(value, field);
  if (value <= 0) {
    throw InvalidInput(text("%s is %g (it must be positive) give a value > 0", field, value));
  }
}
void check_choice(int value, int count, const char* field, const char* names) {
  if (value < 0 || value >= count) {
    throw InvalidInput(text("%s is %d (it is none of %s) give one of them", field, value, names));
  }
}
void check_view(const void* data, uint64_t count, uint32_t stride, size_t element,
                const char* field) {
  if (count >= View<char>::too_many) {
    throw InvalidInput(
        text("%s has 2^32 - 1 elements or more (a view counts fewer) give less at once", field));
  }
  if (count > 0 && data == nullptr) {
    throw InvalidInput(
        text("%s has %llu elements and a null pointer (there is nothing to read) "
             "give the data or a count of 0",
             field, static_cast<unsigned long long>(count)));
  }
  if (count > 1 && stride < element) {
    throw InvalidInput(
        text("%s has a stride of %u bytes (an element takes %zu) give the distance from one to the "
             "next",
             field, stride, element));
  }
}

void check_spring(const Spring& s, uint32_t index, uint32_t vertices, const char* kind) {
  for (const uint32_t v : {s.a, s.b}) {
    if (v >= vertices) {
      throw InvalidInput(text("spring %u names vertex %u (the %s has %u) give an index below that",
                              index, v, kind, vertices));
    }
  }
  if (s.a == s.b) {
    throw InvalidInput(
        text("spring %u joins vertex %u to itself (a spring has two ends) remove it", index, s.a));
  }
  if (s.stiffness != -1)
    check_not_negative(s.stiffness, text("springs[%u].stiffness", index).c_str());
  if (s.rest_length != -1) {
    check_not_negative(s.rest_length, text("springs[%u].rest_length", index).c_str());
  }
}

void check_material(const Material& m, uint32_t vertices) {
  check_not_negative(m.stiffness.stretch, "stiffness.stretch");
  check_not_negative(m.stiffness.shear, "stiffness.shear");
  check_not_negative(m.stiffness.bend, "stiffness.bend");
  if (m.rest_length != initial_rest_length) check_not_negative(m.rest_length, "rest_length");
  check_positive(m.scale, "scale");
  check_choice(int(m.mass.kind), 3, "mass.kind", "total, density, per_vertex");
  if (m.mass.kind != Mass::Kind::per_vertex) return check_positive(m.mass.value, "mass");
  check_view(m.mass.values, "mass.values");
  if (m.mass.values.count != vertices) {
    throw InvalidInput(
        text("mass.values has %u elements (the fabric has %u vertices) give one mass "
             "per vertex",
             m.mass.values.count, vertices));
  }
  for (uint32_t v = 0; v < vertices; ++v) {
    const double mass = m.mass.values[v];
    const bool immobile = mass == std::numeric_limits<double>::infinity();
    if (!immobile && !(mass >= smallest_mass && mass <= largest_value)) {
      throw InvalidInput(
          text("mass of vertex %u is %g (a mass lies in 1e-18 to 1e18 kg, or is infinite for a "
               "vertex that never moves) give a positive mass",
               v, mass));
    }
  }
}

void check_positions(PointView p, const char* field) {
  check_view(p.data, p.count, p.stride, p.is_double ? sizeof(double3) : sizeof(float3), field);
  for (uint32_t v = 0; v < p.count; ++v) {
    const double3 x = p[v];
    for (const double c : {x.x, x.y, x.z}) {
      if (!std::isfinite(c) || std::fabs(c) > largest_coordinate) {
        throw InvalidInput(
            text("%s: vertex %u is at (%g, %g, %g) (coordinates must be finite and "
                 "within 1e9 m) move or scale it",
                 field, v, x.x, x.y, x.z));
      }
    }
  }
}

void store_positions(PointView p, double scale, CookedFabric& fabric) {
  fabric.vertices = p.count;
  fabric.positions.resize(p.count);
  for (uint32_t v = 0; v < p.count; ++v) {
    const double3 x = p[v];
    fabric.positions[v] = {x.x * scale, x.y * scale, x.z * scale};
  }
}

static double triangle_area(const CookedFabric& fabric, const uint32_t* v) {
  Eigen::Vector3d corner[3];
  for (int c = 0; c < 3; ++c) {
    const double3 x = fabric.position_of(v[c]);
    corner[c] = {x.x, x.y, x.z};
  }
  return 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
}

/// A third of each triangle's mass to each of its vertices; the mean to vertices without triangle.
static void set_masses_by_density(double density, CookedFabric& fabric) {
  fabric.masses.assign(fabric.vertices, 0.0);
  Vector<bool> touched(fabric.vertices, false);
  const uint64_t count = triangle_count(fabric);
  for (uint64_t t = 0; t < count; ++t) {
    uint32_t v[3];
    triangle(fabric, t, v);
    const double third = density * triangle_area(fabric, v) / 3;
    for (const uint32_t corner : v) {
      fabric.masses[corner] += third;
      touched[corner] = true;
    }
  }
  double sum = 0;
  uint32_t members = 0, loose = 0, first_loose = 0;
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    if (touched[v]) {
      sum += fabric.masses[v];
      ++members;
    } else if (loose++ == 0) {
      first_loose = v;
    }
  }
  if (members == 0 && fabric.vertices > 0) {
    throw InvalidInput(
        "mass by density (the fabric has no triangle to have an area) give a total "
        "mass or one mass per vertex");
  }
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    if (!touched[v]) fabric.masses[v] = sum / members;
    if (!(fabric.masses[v] >= smallest_mass)) {
      throw InvalidInput(
          text("vertex %u has no mass to speak of (its triangles have no area) give masses "
               "per vertex or mend the mesh",
               v));
    }
  }
  if (loose > 0) {
    fabric.diagnostics.push_back(
        {Severity::warning, first_loose,
         text("%u vertices belong to no triangle, the first is %u: each gets the mean vertex mass "
              "%g kg",
              loose, first_loose, sum / members)});
  }
}

void set_masses(const Mass& mass, CookedFabric& fabric) {
  switch (mass.kind) {
    case Mass::Kind::total:
      fabric.mass = fabric.vertices > 0 ? mass.value / fabric.vertices : mass.value;
      if (fabric.mass < smallest_mass) {
        throw InvalidInput(
            text("mass is %g for %u vertices (each gets less than 1e-18 kg) give more", mass.value,
                 fabric.vertices));
      }
      return;
    case Mass::Kind::density:
      return set_masses_by_density(mass.value, fabric);
    case Mass::Kind::per_vertex:
      fabric.masses.resize(fabric.vertices);
      for (uint32_t v = 0; v < fabric.vertices; ++v) fabric.masses[v] = mass.values[v];
      return;
  }
}

}  // namespace weft::scene
