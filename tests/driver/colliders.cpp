// Colliders alone and in sets.
#include "run.h"

#include <algorithm>

namespace weft_tests::driver {

using weft::Status;

Outcome Run::create_collider(Random& r, ModelWorld& w) {
  if (w.colliders.size() >= 6 && !w.in_flight) return destroy_collider(r, w);
  const bool bad = r.chance(0.15);
  const uint32_t field = r.below(3);
  // The velocity or the friction; field 2 is each shape's own.
  const auto spoilt = [&](auto desc) {
    if (bad && field == 0) desc.velocity = r.bad_vector();
    if (bad && field == 1) desc.friction = r.chance(0.5) ? -1 : r.bad();
    if (r.chance(0.3)) desc.layers = r.below(8);
    return desc;
  };
  weft::Result<weft::ColliderId> made = Status::ok;
  Expect expect = bad ? Expect::refusal : is_extreme_ ? Expect::any : Expect::ok;
  switch (r.below(6)) {
    case 0: {
      weft::SphereDesc d = sphere(r, w);
      if (bad && field == 2) d.radius = r.chance(0.5) ? 0 : r.bad();
      made = w.world.create_sphere(spoilt(d));
      break;
    }
    case 1: {
      weft::PlaneDesc d = plane(r, w);
      if (bad && field == 2) d.normal = r.chance(0.5) ? weft::double3{0, 0, 0} : r.bad_vector();
      made = w.world.create_plane(spoilt(d));
      break;
    }
    case 2: {
      weft::CapsuleDesc d = capsule(r, w);
      if (bad && field == 2) d.a = r.bad_vector();
      made = w.world.create_capsule(spoilt(d));
      break;
    }
    case 3: {
      weft::CylinderDesc d = cylinder(r, w);
      if (bad && field == 2) d.b = d.a;
      made = w.world.create_cylinder(spoilt(d));
      break;
    }
    case 4: {
      weft::BoxDesc d = box(r, w);
      if (bad && field == 2) d.half.z = r.chance(0.5) ? 0 : r.bad();
      made = w.world.create_box(spoilt(d));
      break;
    }
    default: {
      weft::MeshColliderDesc d;
      const Home& home = *homes_[r.chance(0.9) ? w.home : 1 - w.home];
      if (!home.meshes.empty()) d.mesh = home.meshes[r.below(home.meshes.size())];
      if (d.mesh.triangle_count() == 0) expect = Expect::refusal;
      d.pose = pose(r, w.at);
      if (r.chance(0.3)) d.velocity = r.vector(1);
      if (bad && field == 2) d.pose.translate = r.bad_vector();
      made = w.world.create_mesh(spoilt(d));
    }
  }
  if (!made) return {made.status(), expect, 0};
  remember(colliders_given_, *made);
  w.colliders.push_back(*made);
  return {Status::ok, expect, 0};
}

Outcome Run::destroy_collider(Random& r, ModelWorld& w) {
  const bool is_there = !w.colliders.empty() && r.chance(0.85);
  const uint32_t at = r.below(w.colliders.size());
  const weft::ColliderId id =
      is_there ? w.colliders[at] : pick_other(r, w.dead_colliders, w.colliders);
  const Status status = w.world.destroy_collider(id);
  if (status == Status::ok && is_there) {
    w.colliders.erase(w.colliders.begin() + at);
    w.dead_colliders.push_back(id);
  }
  return {status, is_there ? Expect::ok : Expect::handle, 0};
}

Outcome Run::move_collider(Random& r, ModelWorld& w) {
  const bool is_there = !w.colliders.empty() && r.chance(0.9);
  const weft::ColliderId id = is_there ? w.colliders[r.below(w.colliders.size())]
                                       : pick_other(r, w.dead_colliders, w.colliders);
  // A rotation is about the origin; far from it the way back is part of the pose.
  weft::Pose to = pose(r, {0, 0, 0});
  if (w.at.x != 0 || w.at.z != 0) to.degrees = 0;
  if (r.chance(0.2)) to = {};
  auto how = weft::Move(r.below(2));
  Expect expect = !is_there ? Expect::handle : is_extreme_ ? Expect::any : Expect::ok;
  if (is_there && r.chance(0.15)) {
    expect = Expect::refusal;
    switch (r.below(3)) {
      case 0:
        how = weft::Move(r.from_to(2, 255));
        break;
      case 1:
        to.translate = r.bad_vector();
        break;
      default:
        to.degrees = 1;
        to.axis = {0, 0, 0};
    }
  }
  return {w.world.move_collider(id, to, how), expect, 0};
}

static void spoil_set(Random& r, ModelSet& set) {
  switch (r.below(3)) {
    case 0:
      if (!set.spheres.empty()) {
        set.spheres.back().center = r.bad_vector();
        return;
      }
      [[fallthrough]];
    case 1:
      if (!set.boxes.empty()) {
        set.boxes.front().half.x = r.bad();
        return;
      }
      [[fallthrough]];
    default: {
      weft::CapsuleDesc bad;
      bad.b = r.bad_vector();
      set.capsules.push_back(bad);
    }
  }
}

Outcome Run::create_set(Random& r, ModelWorld& w) {
  if (w.sets.size() >= 2 && !w.in_flight) return destroy_set(r, w);
  ModelSet set;
  for (uint32_t i = r.below(3); i > 0; --i) set.spheres.push_back(sphere(r, w));
  for (uint32_t i = r.below(2); i > 0; --i) set.planes.push_back(plane(r, w));
  for (uint32_t i = r.below(4); i > 0; --i) set.capsules.push_back(capsule(r, w));
  for (uint32_t i = r.below(2); i > 0; --i) set.cylinders.push_back(cylinder(r, w));
  for (uint32_t i = r.below(2); i > 0; --i) set.boxes.push_back(box(r, w));
  Expect expect = is_extreme_ ? Expect::any : Expect::ok;
  if (r.chance(0.15)) {
    spoil_set(r, set);
    expect = Expect::refusal;
  }
  const weft::Result<weft::ColliderSetId> made = w.world.create_collider_set(set.desc());
  if (!made) return {made.status(), expect, 0};
  set.id = *made;
  remember(sets_given_, set.id);
  w.sets.push_back(std::move(set));
  return {Status::ok, expect, 0};
}

/// The segment in a new direction, of the same length up to rounding.
static void turn(Random& r, weft::double3& a, weft::double3& b) {
  const weft::double3 d{b.x - a.x, b.y - a.y, b.z - a.z}, by = r.vector(0.3);
  const double length = std::hypot(d.x, d.y, d.z);
  weft::double3 to{d.x + by.x * length, d.y + by.y * length, d.z + by.z * length};
  const double scale = length / std::fmax(std::hypot(to.x, to.y, to.z), 1e-300);
  b = {a.x + to.x * scale, a.y + to.y * scale, a.z + to.z * scale};
}

Outcome Run::move_set(Random& r, ModelWorld& w) {
  const bool is_there = !w.sets.empty() && r.chance(0.9);
  const uint32_t at = r.below(w.sets.size());
  ModelSet set = is_there ? w.sets[at] : ModelSet();
  if (!is_there) set.id = pick_other(r, w.dead_sets, w.sets);
  const weft::double3 by = r.chance(0.2) ? weft::double3{0, 0, 0} : r.vector(0.3);
  const auto moved = [&](weft::double3& p) { p = {p.x + by.x, p.y + by.y, p.z + by.z}; };
  for (auto& s : set.spheres) moved(s.center);
  for (auto& p : set.planes) p.offset += r.real(-0.1, 0.1);
  for (auto& c : set.capsules) {
    moved(c.a);
    moved(c.b);
    if (r.chance(0.5)) turn(r, c.a, c.b);
  }
  for (auto& c : set.cylinders) {
    moved(c.a);
    moved(c.b);
    if (r.chance(0.5)) turn(r, c.a, c.b);
  }
  for (auto& b : set.boxes) {
    moved(b.center);
    b.degrees += r.real(-40, 40);
  }
  auto how = weft::Move(r.below(4) == 0 ? 1 : 0);
  Expect expect = !is_there ? Expect::handle : is_extreme_ ? Expect::any : Expect::ok;
  const bool stretches = r.chance(0.3);
  if (stretches) {
    for (auto& s : set.spheres) s.radius *= r.real(0.8, 1.2);
    for (auto& c : set.capsules) c.radius *= r.real(0.8, 1.2);
  }
  ModelSet sent = set;
  if (is_there && r.chance(0.15)) {
    expect = Expect::refusal;
    const uint32_t kind = r.below(4);
    if (kind == 0) {
      spoil_set(r, sent);
    } else if (kind == 1) {
      how = weft::Move(r.from_to(2, 255));
    } else if (kind == 2 || sent.spheres.empty() || stretches) {
      sent.spheres.push_back(sphere(r, w));
    } else {
      sent.spheres.back().radius *= 1.5;
      if (is_extreme_) expect = Expect::any;  // of a grain, less than the rounding of its place
    }
  }
  weft::ColliderSetDesc desc = sent.desc();
  desc.may_stretch = stretches;
  const Status status = w.world.move_collider_set(set.id, desc, how);
  if (status == Status::ok && is_there) w.sets[at] = std::move(set);
  return {status, expect, 0};
}

Outcome Run::destroy_set(Random& r, ModelWorld& w) {
  const bool is_there = !w.sets.empty() && r.chance(0.85);
  const uint32_t at = r.below(w.sets.size());
  const weft::ColliderSetId id = is_there ? w.sets[at].id : pick_other(r, w.dead_sets, w.sets);
  const Status status = w.world.destroy_collider_set(id);
  if (status == Status::ok && is_there) {
    w.sets.erase(w.sets.begin() + at);
    w.dead_sets.push_back(id);
  }
  return {status, is_there ? Expect::ok : Expect::handle, 0};
}

}  // namespace weft_tests::driver
