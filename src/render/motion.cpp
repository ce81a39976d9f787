// How far cloths go in a run that is still to come.
#include "render/framing.h"

#include <algorithm>

namespace weft::render {
namespace {

bool touches(const Box& box, const Solid& solid) {
  if (solid.kind == Solid::Kind::body) return !box.within(solid.box).empty();
  const Vector3d &normal = solid.surface.normals[0], &foot = solid.surface.places[0];
  for (int i = 0; i < 8; ++i) {
    if (normal.dot(box.corner(i) - foot) < 0) return true;
  }
  return false;
}

/// As a pendulum around a box of pins, hanging between them, and in the wind.
void add_pinned(const io::Scene& scene, const Box& pins, const std::vector<Vector3d>& places,
                Framing& framing) {
  const bool falls = vector(scene.gravity).norm() > 0;
  const Vector3d up = up_of(scene);
  const Vector3d wind = scene.wind ? vector(scene.wind->velocity).normalized() : Vector3d::Zero();
  if (falls) framing.add(pins.center() - 0.4 * pins.radius() * up);
  for (const Vector3d& p : places) {
    const Vector3d hinge = pins.nearest(p), arm = p - hinge;
    framing.add(hinge + arm.norm() * wind);
    if (!falls) continue;
    framing.add(hinge - arm.norm() * up);
    framing.add(hinge - arm + 2 * arm.dot(up) * up);
  }
}

/// Until it is at a collider, over whose rim it may hang.
void add_free(const io::Scene& scene, const io::ClothScene& cloth,
              const std::vector<Vector3d>& places, const Box& start,
              const std::vector<Solid>& solids, Framing& framing) {
  constexpr int moments = 32;
  const double size = start.radius(), most = size > 0 ? 10 * size : 1e300;
  Vector3d velocity = vector(cloth.velocity);
  for (const double3& v : cloth.velocities) {
    velocity += vector(v) / double(cloth.velocities.size());
  }
  const auto way = [&](double t) -> Vector3d {
    return velocity * t + 0.5 * t * t * vector(scene.gravity);
  };
  double last = scene.time.duration;
  while (way(last).norm() > most) last *= 0.9;
  for (int i = 1; i <= moments; ++i) {
    const Vector3d by = way(last * i / moments);
    const Box box = start.moved(by);
    const auto hit = std::find_if(solids.begin(), solids.end(),
                                  [&](const Solid& solid) { return touches(box, solid); });
    for (const Vector3d& p : places) framing.add(p + by);
    if (hit == solids.end()) continue;
    framing.add(box);  // it spreads
    if (hit->kind == Solid::Kind::body) {
      const Box middle{0.5 * (box.low + box.center()), 0.5 * (box.high + box.center())};
      framing.add(middle.moved(-0.9 * size * up_of(scene)));
    }
    return;
  }
}

}  // namespace

void add_cloths(const io::Scene& scene, const io::Surface& start, const std::vector<Solid>& solids,
                Framing& framing) {
  for (size_t i = 0; i < start.parts.size(); ++i) {
    const io::ClothScene& cloth = scene.cloths[i];
    const auto first = start.positions.begin() + std::ptrdiff_t(start.parts[i].first_vertex);
    std::vector<Vector3d> places(start.parts[i].vertex_count);
    std::transform(first, first + std::ptrdiff_t(places.size()), places.begin(), vector);
    Box box, pins;
    for (const Vector3d& p : places) {
      box.add(p);
      framing.add(p);
    }
    for (const Pin& pin : cloth.pins) pins.add(places[pin.vertex]);
    for (const PinMotion& motion : cloth.motions) {
      for (const double time : {0.0, scene.time.duration}) {
        framing.add(box.moved(vector(motion.velocity) * time + vector(motion.amplitude)));
        framing.add(box.moved(vector(motion.velocity) * time - vector(motion.amplitude)));
      }
    }
    if (pins.empty())
      add_free(scene, cloth, places, box, solids, framing);
    else
      add_pinned(scene, pins, places, framing);
  }
}

}  // namespace weft::render
