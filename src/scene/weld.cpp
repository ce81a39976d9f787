#include "scene/weld.h"

#include "scene/places.h"

namespace weft::scene {

Welded weld(const MeshDesc& desc) {
  Welded out;
  const double distance = desc.weld_distance / desc.material.scale;
  Places places(distance, distance);
  const View<double>& masses = desc.material.mass.values;
  for (uint32_t v = 0; v < desc.positions.count; ++v) {
    const uint32_t before = places.count();
    out.particle_of.push_back(places.of(desc.positions[v]));
    if (places.count() > before && !masses.empty()) out.masses.push_back(masses[v]);
  }
  out.positions = std::move(places.positions());
  for (uint32_t t = 0; t < desc.indices.count / 3; ++t) {
    const uint32_t a = out.particle_of[desc.indices[3 * t]],
                   b = out.particle_of[desc.indices[3 * t + 1]],
                   c = out.particle_of[desc.indices[3 * t + 2]];
    if (a == b || b == c || a == c) {
      ++out.dropped;
    } else {
      out.indices.insert(out.indices.end(), {a, b, c});
      out.given.push_back(t);
    }
  }
  for (uint32_t s = 0; s < desc.springs.count; ++s) {
    Spring spring = desc.springs[s];
    spring.a = out.particle_of[spring.a];
    spring.b = out.particle_of[spring.b];
    if (spring.a == spring.b)
      ++out.dropped_springs;
    else
      out.springs.push_back(spring);
  }
  out.mesh = desc;
  out.mesh.positions = View<double3>(out.positions);
  out.mesh.indices = out.indices;
  out.mesh.springs = out.springs;
  out.mesh.weld_distance = 0;
  if (!out.masses.empty()) out.mesh.material.mass.values = out.masses;
  return out;
}

}  // namespace weft::scene
