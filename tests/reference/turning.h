// What tests of turning colliders share: places far from the origin, dust about them, a pose that
// turns about a point, and the limbs of a character.
#pragma once

#include "reference/effects.h"

namespace weft_tests {

constexpr Vec far_places[] = {
    {0, 0, 0}, {5000, 0, 0}, {0, -5000, 3}, {0, 0, 1e5}, {-1e5, 7e4, 1e5}};

/// Loose particles about a place, in a lattice that no axis favours.
inline std::vector<Vec> dust() {
  std::vector<Vec> at;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = -4; k <= 4; ++k)
        at.push_back(0.113 * (double(i) * ahead + double(j) * across + double(k) * beside));
  return at;
}
inline weft::ClothId add_dust(TestWorld& test, Vec place) {
  const std::vector<weft::double3> points = to_weft(dust());
  weft::NetworkDesc desc;
  desc.positions = weft::View<weft::double3>(points);
  desc.material.mass.value = double(points.size());
  weft::ClothDesc cloth;
  cloth.pose.translate = to_weft(place);
  return test.add(desc, cloth);
}

/// The pose that turns about `pivot` and then moves by `by`.
inline weft::Pose about(Vec pivot, Vec by, Vec axis, double degrees) {
  return {to_weft(axis), degrees, to_weft(pivot + by - turned(pivot, axis, degrees))};
}

/// Three descriptions of each shape in a set, of which `angle` turns all about their own middles.
struct Limbs {
  Limbs(Vec place, double angle, bool in_float, double scale = 1) {
    const auto put = [&](Vec v) {
      v = place + v;
      return in_float ? to_weft(reference::through_float(v)) : to_weft(v);
    };
    const auto rod = [&](auto& rods, Vec middle, Vec axis, double half) {
      typename std::decay_t<decltype(rods)>::value_type d;
      const Vec along = turned(half * scale * axis, {1, 2, 3}, angle);
      d.a = put(middle - along);
      d.b = put(middle + along);
      d.radius = 0.05 * scale;
      rods.push_back(d);
    };
    rod(capsules, {-0.3, 0, 0}, ahead, 0.15);
    rod(capsules, {0.3, 0, 0}, {0, 1, 0}, 0.2);
    rod(cylinders, {0, 0, 0.3}, across, 0.12);
    weft::BoxDesc box;
    box.center = put({0, 0, -0.3});
    box.half = {0.1 * scale, 0.05 * scale, 0.02 * scale};
    box.axis = {1, 2, 3};
    box.degrees = angle;
    boxes.push_back(box);
    weft::SphereDesc sphere;
    sphere.center = put({0, 0.1, 0});
    sphere.radius = 0.07 * scale;
    spheres.push_back(sphere);
  }
  weft::ColliderSetDesc desc() const {
    weft::ColliderSetDesc d;
    d.spheres = spheres;
    d.capsules = capsules;
    d.cylinders = cylinders;
    d.boxes = boxes;
    return d;
  }
  std::vector<weft::SphereDesc> spheres;
  std::vector<weft::CapsuleDesc> capsules;
  std::vector<weft::CylinderDesc> cylinders;
  std::vector<weft::BoxDesc> boxes;
};

}  // namespace weft_tests
