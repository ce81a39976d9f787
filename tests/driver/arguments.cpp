// Pieces of arguments, good unless they are spoilt.
#include "run.h"

namespace weft_tests::driver {

double Run::number(Random& r, double low, double high) const {
  const double ordinary = r.real(low, high);
  return is_extreme_ && r.chance(0.03) ? r.extreme() : ordinary;
}

weft::double3 Run::place(Random& r, const ModelWorld& w, double reach) const {
  const weft::double3 v{number(r, -reach, reach), number(r, -reach, reach),
                        number(r, -reach, reach)};
  return {w.at.x + v.x, w.at.y + v.y, w.at.z + v.z};
}

weft::Pose Run::pose(Random& r, const weft::double3& about) const {
  weft::Pose pose;
  pose.axis = r.vector(1);
  pose.degrees = r.chance(0.3) ? 0 : number(r, -400, 400);
  pose.translate = {about.x + r.real(-0.5, 0.5), about.y + r.real(-0.5, 0.5),
                    about.z + r.real(-0.5, 0.5)};
  return pose;
}

weft::Material Run::material(Random& r, uint32_t vertices, std::vector<double>& masses) const {
  weft::Material m;
  m.stiffness = {std::fabs(number(r, 0, 200)), std::fabs(number(r, 0, 100)),
                 r.chance(0.2) ? 0 : std::fabs(number(r, 0, 50))};
  if (r.chance(0.2)) m.rest_length = std::fabs(number(r, 0, 0.5));
  m.mass.value = is_extreme_ && r.chance(0.1) ? r.one_of({1e-12, 1e-3, 1e6, 1e12}) : r.real(0.1, 2);
  if (r.chance(0.2)) m.scale = r.real(0.5, 2);
  if (r.chance(0.2)) {
    m.mass.kind = weft::Mass::Kind::per_vertex;
    for (uint32_t v = 0; v < vertices; ++v) {
      masses.push_back(r.chance(0.1) ? std::numeric_limits<double>::infinity() : r.real(0.01, 0.2));
    }
    m.mass.values = masses;
  }
  return m;
}

void Run::spoil(Random& r, weft::Material& m) {
  switch (r.below(7)) {
    case 0:
      m.stiffness.stretch = r.chance(0.5) ? -1 : r.bad();
      return;
    case 1:
      m.stiffness.bend = r.chance(0.5) ? -2 : r.bad();
      return;
    case 2:
      m.rest_length = r.chance(0.5) ? -0.5 : r.bad();
      return;
    case 3:
      m.scale = r.chance(0.5) ? 0 : r.bad();
      return;
    case 4:
      m.mass = {};
      m.mass.value = r.chance(0.5) ? 0 : r.bad();
      return;
    case 5:
      m.mass.kind = weft::Mass::Kind(77);
      return;
    default:
      m.mass.kind = weft::Mass::Kind::per_vertex;
      m.mass.values = {nullptr, r.from_to(1, 5)};
  }
}

std::vector<weft::double3> Run::sheet(Random& r, uint32_t rows, uint32_t columns) {
  std::vector<weft::double3> x;
  for (uint32_t i = 0; i < rows * columns; ++i) {
    x.push_back({0.2 * (i % columns) + r.real(-0.03, 0.03), r.real(-0.03, 0.03),
                 0.2 * (i / columns) + r.real(-0.03, 0.03)});
  }
  return x;
}

std::vector<uint32_t> Run::triangles(uint32_t rows, uint32_t columns) {
  std::vector<uint32_t> all;
  for (uint32_t row = 0; row + 1 < rows; ++row) {
    for (uint32_t column = 0; column + 1 < columns; ++column) {
      const uint32_t a = row * columns + column, c = a + columns;
      all.insert(all.end(), {a, c, a + 1, a + 1, c, c + 1});
    }
  }
  return all;
}

/// Exactly as many bytes as the view names.
Run::Points Run::stored(Random& r, const std::vector<weft::double3>& points) {
  Points made;
  const bool wide = r.chance(0.5);
  const uint32_t scalar = wide ? 8 : 4, stride = scalar * r.from_to(3, 5);
  if (!points.empty()) made.bytes.resize((points.size() - 1) * stride + size_t(3) * scalar);
  for (size_t i = 0; i < points.size(); ++i) {
    const weft::double3& p = points[i];
    const weft::float3 narrow{float(p.x), float(p.y), float(p.z)};
    const void* from = wide ? static_cast<const void*>(&p) : &narrow;
    std::memcpy(&made.bytes[i * stride], from, size_t(3) * scalar);
  }
  made.view.data = made.bytes.data();
  made.view.count = static_cast<uint32_t>(points.size());
  made.view.stride = stride;
  made.view.is_double = wide;
  return made;
}

/// Of a view that has points.
void Run::spoil(Random& r, Points& points) {
  weft::PointView& view = points.view;
  unsigned char* at = &points.bytes[size_t(r.below(view.count)) * view.stride];
  switch (r.below(3)) {
    case 0:
      view.data = nullptr;
      return;
    case 1:
      if (view.count > 1) {
        view.stride = r.below(view.is_double ? 24 : 12) & ~7u;
        return;
      }
      [[fallthrough]];
    default: {
      const double value = r.chance(0.3) ? 2e9 : r.bad();
      const auto narrow = static_cast<float>(
          std::isfinite(value) && std::fabs(value) > 3e38 ? std::copysign(3e38, value) : value);
      if (view.is_double) {
        std::memcpy(at + 8 * r.below(3), &value, 8);
      } else {
        std::memcpy(at + 4 * r.below(3), &narrow, 4);
      }
    }
  }
}

weft::SphereDesc Run::sphere(Random& r, const ModelWorld& w) const {
  weft::SphereDesc d;
  d.center = place(r, w, 0.8);
  d.radius = std::fabs(number(r, 0.05, 0.4)) + 1e-9;
  if (r.chance(0.3)) d.velocity = r.vector(2);
  d.friction = r.chance(0.5) ? 0 : std::fabs(number(r, 0, 1));
  return d;
}

weft::PlaneDesc Run::plane(Random& r, const ModelWorld& w) const {
  weft::PlaneDesc d;
  d.normal = r.chance(0.5) ? weft::double3{0, 1, 0} : r.vector(1);
  const double size = std::hypot(d.normal.x, d.normal.y, d.normal.z);
  d.offset =
      (d.normal.x * w.at.x + d.normal.y * w.at.y + d.normal.z * w.at.z) / size - number(r, 0.2, 1);
  if (r.chance(0.3)) d.velocity = r.vector(1);
  d.friction = r.chance(0.5) ? 0 : r.real(0, 1);
  return d;
}

weft::CapsuleDesc Run::capsule(Random& r, const ModelWorld& w) const {
  weft::CapsuleDesc d;
  d.a = place(r, w, 0.8);
  d.b = place(r, w, 0.8);
  if (r.chance(0.05)) d.b = d.a;
  d.radius = std::fabs(number(r, 0.03, 0.2)) + 1e-9;
  if (r.chance(0.3)) d.velocity = r.vector(2);
  d.friction = r.chance(0.5) ? 0 : r.real(0, 1);
  return d;
}

weft::CylinderDesc Run::cylinder(Random& r, const ModelWorld& w) const {
  const weft::CapsuleDesc from = capsule(r, w);
  weft::CylinderDesc d;
  d.a = from.a;
  d.b = {from.a.x + r.real(0.1, 0.5), from.b.y, from.b.z};
  d.radius = from.radius;
  d.velocity = from.velocity;
  d.friction = from.friction;
  return d;
}

weft::BoxDesc Run::box(Random& r, const ModelWorld& w) const {
  weft::BoxDesc d;
  d.center = place(r, w, 0.8);
  d.half = {r.real(0.05, 0.3), std::fabs(number(r, 0.05, 0.3)) + 1e-9, r.real(0.05, 0.3)};
  d.axis = r.vector(1);
  d.degrees = r.chance(0.3) ? 0 : number(r, -360, 360);
  if (r.chance(0.3)) d.velocity = r.vector(2);
  d.friction = r.chance(0.5) ? 0 : r.real(0, 1);
  return d;
}

/// One that is there or, with null, an id that names nothing.
ModelCloth* Run::pick_cloth(Random& r, ModelWorld& w, weft::ClothId& id) {
  if (!w.cloths.empty() && r.chance(0.9)) {
    ModelCloth& cloth = w.cloths[r.below(w.cloths.size())];
    id = cloth.id;
    return &cloth;
  }
  id = pick_other(r, w.dead_cloths, w.cloths);
  for (const auto& other : worlds_) {
    if (other.get() != &w && !other->cloths.empty() && r.chance(0.5)) id = other->cloths[0].id;
  }
  return nullptr;
}

}  // namespace weft_tests::driver
