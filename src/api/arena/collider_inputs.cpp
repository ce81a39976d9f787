#include "api/arena/collider_inputs.h"

#include <algorithm>
#include <cstring>

#include "api/arena/image.h"
#include "api/arena/collider_mesh_arrays.h"
#include "api/context/vector_math.h"

namespace weft::api {

namespace {

double3 box_low(const double3& a, double by) { return {a.x - by, a.y - by, a.z - by}; }
double3 box_high(const double3& a, double by) { return {a.x + by, a.y + by, a.z + by}; }

/// What goes to the device, and where.
struct Upload {
  const void* to;
  const void* from;
  size_t bytes;
};
template <class Element>
Upload upload_of(const Element* to, const Vector<Element>& from, size_t count) {
  return {to, from.data(), count * sizeof(Element)};
}
template <class Element>
Upload upload_of(const Element* to, const Vector<Element>& from) {
  return upload_of(to, from, from.size());
}

template <class T>
Vec3<T>& place_of(Sphere<T>& s) {
  return s.center;
}
template <class T>
Vec3<T>& place_of(Capsule<T>& c) {
  return c.a;
}
template <class T>
Vec3<T>& place_of(Cylinder<T>& c) {
  return c.a;
}
template <class T>
Vec3<T>& place_of(Box<T>& b) {
  return b.center;
}
template <class T>
Vec3<T>& place_of(MeshCollider<T>& m) {
  return m.translate;
}

}  // namespace

template <class T>
template <class Shape>
void ColliderInputs<T>::Staged<Shape>::place(const ClothRecord& record, size_t cloth) {
  Shape* to = all.data() + cloth * seen.size();
  for (const Seen<Shape>& s : seen) {
    if (!may_meet(record, *s.record)) continue;
    *to = s.shape;
    place_of(*to) = narrow<T>(minus(s.at, record.origin));
    to->surface.pivot = narrow<T>(minus(s.pivot, record.origin));
    ++to;
  }
}

template <class T>
void ColliderInputs<T>::prepare(const ArenaInput& in, const plan::DeviceArrays<T>& image) {
  const Counts counts = plan::counts_of(in.shape);
  const size_t cloths = in.cloths.size(), colliders = size_t(counts.all_colliders);
  const auto size = [&](auto& staged, ColliderShape shape) {
    const size_t count = in.shape.colliders[int(shape)];
    staged.seen.clear();
    staged.seen.reserve(count);
    staged.all.resize(cloths * count);
  };
  size(spheres_, ColliderShape::sphere);
  planes_.resize(cloths * in.shape.colliders[int(ColliderShape::plane)]);
  size(capsules_, ColliderShape::capsule);
  size(cylinders_, ColliderShape::cylinder);
  size(boxes_, ColliderShape::box);
  size(meshes_, ColliderShape::mesh);
  followed_.clear();
  followed_.reserve(colliders);
  near_.resize(cloths * colliders);
  near_bounds_.resize(near_.size());
  activity_.assign(counts.uses_activity ? cloths : 0, ClothActivity<T>{});
  columns_ = in.shape.turning_colliders;
  turns_.resize(columns_ > 0 ? columns_ * (size_t(in.shape.substeps) + 1) : 0);
  for (size_t m = 0; m < in.meshes.size(); ++m) fill_grid(*in.meshes[m], image.meshes[m]);
}

/// Where everything goes in this frame.
template <class T>
void ColliderInputs<T>::follow(const ArenaInput& in, const FrameInput& input,
                               const plan::DeviceArrays<T>& device) {
  followed_.clear();
  spheres_.seen.clear();
  capsules_.seen.clear();
  cylinders_.seen.clear();
  boxes_.seen.clear();
  meshes_.seen.clear();
  int32_t column = 0;
  for (int shape = 0; shape < collider_shapes; ++shape) {
    if (in.shape.colliders[shape] == 0) continue;
    for (const ColliderRecord& c : *in.colliders) {
      if (!c.id || static_cast<int>(c.shape) != shape) continue;
      const ColliderPath path = path_of(c, input.time, input.substeps * input.dt);
      const SweptBounds bounds = swept_bounds(c, path);
      const double3 size = minus(bounds.high, bounds.low);
      const double extent = std::max({size.x, size.y, size.z}) + bounds.radius;
      const double slack = c.shape == ColliderShape::plane ? 0 : 1e-6 * extent;
      followed_.push_back({&c, path, bounds, path.turns ? column : -1, slack});
      see(followed_.back(), in, device);
      if (c.can_turn) ++column;
    }
  }
}

template <class T>
void ColliderInputs<T>::stage_turns(const FrameInput& input) {
  for (const Followed& e : followed_) {
    if (e.turn < 0) continue;
    TurnInParts turn(e.path.begin, e.path.end, input.substeps);
    static_assert(sizeof(Mat3<T>) == 9 * sizeof(T));
    Mat3<T>* to = turns_.data() + e.turn;
    *to = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int s = 1; s <= input.substeps; ++s) {
      T numbers[9];
      turn.next(numbers);
      to += columns_;
      std::memcpy(to, numbers, sizeof numbers);
    }
  }
}

/// What all cloths see alike of a collider that is no plane.
template <class T>
void ColliderInputs<T>::see(const Followed& e, const ArenaInput& in,
                            const plan::DeviceArrays<T>& device) {
  const ColliderRecord& c = *e.record;
  const Placed& placed = e.path.begin;
  const auto along = [&](const double3& v) { return narrow<T>(rotate(placed.rows, v)); };
  const Vec3<T> none{};
  const Surface<T> surface{narrow<T>(e.path.velocity), static_cast<T>(c.friction),
                           static_cast<T>(c.sweep), e.turn, none};
  const double3 &at = e.path.at, &pivot = placed.translate;
  const T size = static_cast<T>(c.size);
  switch (c.shape) {
    case ColliderShape::sphere:
      spheres_.seen.push_back({{none, size, surface}, at, pivot, &c});
      break;
    case ColliderShape::plane:
      break;
    case ColliderShape::capsule: {
      const double length2 = inner(c.axis, c.axis);
      const T inverse = static_cast<T>(length2 > 0 ? 1 / length2 : 0);
      capsules_.seen.push_back(
          {{none, along(c.axis), inverse, size, along(c.side), surface}, at, pivot, &c});
      break;
    }
    case ColliderShape::cylinder:
      cylinders_.seen.push_back(
          {{none, along(c.axis), static_cast<T>(c.length), size, along(c.side), surface},
           at,
           pivot,
           &c});
      break;
    case ColliderShape::box:
      boxes_.seen.push_back({{none,
                              {along(c.edges[0]), along(c.edges[1]), along(c.edges[2])},
                              narrow<T>(c.half),
                              surface},
                             at,
                             pivot,
                             &c});
      break;
    case ColliderShape::mesh: {
      MeshCollider<T> mesh{};
      mesh.rotation = {
          {narrow<T>(placed.rows[0]), narrow<T>(placed.rows[1]), narrow<T>(placed.rows[2])}};
      mesh.surface = surface;
      const size_t m = in.mesh_of_collider[meshes_.seen.size()];
      mesh.grid = device.meshes[m];
      set_numbers(*in.meshes[m], mesh.grid);
      meshes_.seen.push_back({mesh, at, pivot, &c});
      break;
    }
  }
}

template <class T>
Plane<T> ColliderInputs<T>::plane_of(const Followed& e, const double3& origin, double dt) const {
  const ColliderRecord& c = *e.record;
  const double3 normal = rotate(e.path.begin.rows, c.normal);
  Plane<T> plane{};
  plane.normal = narrow<T>(normal);
  const ColliderPath seen = e.path.turns ? seen_from(origin, e.path, c, dt) : e.path;
  plane.surface = {narrow<T>(seen.velocity), static_cast<T>(c.friction), static_cast<T>(c.sweep),
                   e.turn, narrow<T>(minus(seen.begin.translate, origin))};
  plane.offset = static_cast<T>(offset_of(c, e.path) - inner(normal, origin));
  return plane;
}

/// The colliders that a cloth may meet, in its frame.
template <class T>
void ColliderInputs<T>::place_all(const ClothRecord& record, double dt, size_t cloth) {
  spheres_.place(record, cloth);
  capsules_.place(record, cloth);
  cylinders_.place(record, cloth);
  boxes_.place(record, cloth);
  meshes_.place(record, cloth);
  if (planes_.empty()) return;
  const size_t first_plane = spheres_.seen.size();  // the planes follow the spheres
  const size_t planes = followed_.size() - first_plane - capsules_.seen.size() -
                        cylinders_.seen.size() - boxes_.seen.size() - meshes_.seen.size();
  Plane<T>* to = planes_.data() + cloth * planes;
  for (size_t i = first_plane; i < first_plane + planes; ++i) {
    if (may_meet(record, *followed_[i].record)) *to++ = plane_of(followed_[i], record.origin, dt);
  }
}

/// Lists the colliders that a cloth can touch, at near_[first] and on; returns how many.
template <class T>
size_t ColliderInputs<T>::find_near(const ClothRecord& cloth, double margin, double dt,
                                    size_t first, ClothActivity<T>& activity) {
  // Rounding to T must not take anything off the list.
  const double slack = 1e-6 * (length(cloth.low) + length(cloth.high)) + 1e-9;
  const double3 low = plus(box_low(cloth.low, margin + slack), cloth.origin);
  const double3 high = plus(box_high(cloth.high, margin + slack), cloth.origin);
  size_t next = first, e = 0;
  for (int shape = 0; shape < collider_shapes; ++shape) {
    activity.near_first[shape] = static_cast<int>(next);
    int32_t next_index = 0;
    for (; e < followed_.size(); ++e) {
      const Followed& f = followed_[e];
      if (static_cast<int>(f.record->shape) != shape) break;
      if (!may_meet(cloth, *f.record)) continue;
      const int32_t index = next_index++;
      if (!overlaps(box_low(low, f.slack), box_high(high, f.slack), f.bounds)) continue;
      const bool tilts = f.record->shape == ColliderShape::plane && f.path.turns;
      const SweptBounds r = tilts ? swept_bounds_in(low, high, *f.record,
                                                    seen_from(cloth.origin, f.path, *f.record, dt))
                                  : f.bounds;
      if (tilts && !overlaps(low, high, r)) continue;
      const double by = slack + f.slack;
      near_[next] = index;
      near_bounds_[next] = {narrow<T>(box_low(minus(r.low, cloth.origin), by)),
                            narrow<T>(box_high(minus(r.high, cloth.origin), by)),
                            static_cast<T>((r.radius + by) * (r.radius + by)), narrow<T>(r.normal),
                            static_cast<T>(r.offset - inner(r.normal, cloth.origin) + by)};
      ++next;
    }
    activity.near_end[shape] = static_cast<int>(next);
  }
  return next - first;
}

/// The margin is a guess at how far the particles go in the frame: too small costs time, for
/// whoever leaves the region meets all colliders, but never a contact.
template <class T>
void ColliderInputs<T>::stage_activity(const ClothRecord& cloth, const FrameInput& input,
                                       double gravity, size_t first_near,
                                       ClothActivity<T>& activity) {
  activity = {};
  activity.asleep = cloth.asleep ? 1 : 0;
  activity.settling = cloth.settling;
  activity.nearness = Nearness::every;
  if (followed_.empty()) return;
  const double time = input.substeps * input.dt;
  const double size = length(minus(cloth.high, cloth.low));
  const double before = cloth.moved ? input.dt_before : input.dt;
  const double margin =
      1.5 * cloth.furthest * (time / before) + gravity * time * time + 1e-3 * size;
  if (!std::isfinite(margin) || !std::isfinite(size)) return;
  const size_t near = find_near(cloth, margin, time, first_near, activity);
  activity.nearness = near == 0 ? Nearness::cloth : Nearness::block;
  activity.low = narrow<T>(box_low(cloth.low, margin));
  activity.high = narrow<T>(box_high(cloth.high, margin));
  activity.margin = static_cast<T>(margin);
  by_block_ |= activity.nearness == Nearness::block;
}

template <class T>
Status ColliderInputs<T>::upload(const ArenaInput& in, const FrameInput& input,
                                 const plan::DeviceArrays<T>& device) {
  by_block_ = false;
  if (activity_.empty()) return Status::ok;
  follow(in, input, device);
  stage_turns(input);
  const double gravity = length(in.world->gravity), time = input.substeps * input.dt;
  for (size_t c = 0; c < in.cloths.size(); ++c) {
    place_all(*in.cloths[c], time, c);
    stage_activity(*in.cloths[c], input, gravity, c * followed_.size(), activity_[c]);
  }

  const Colliders<T>& to = device.sim.colliders;
  const size_t turns = columns_ > 0 ? columns_ * (size_t(input.substeps) + 1) : 0;
  const Upload uploads[] = {
      upload_of(to.spheres, spheres_.all),     upload_of(to.planes, planes_),
      upload_of(to.capsules, capsules_.all),   upload_of(to.cylinders, cylinders_.all),
      upload_of(to.boxes, boxes_.all),         upload_of(to.meshes, meshes_.all),
      upload_of(to.turn, turns_, turns),       upload_of(to.near, near_),
      upload_of(to.near_bounds, near_bounds_), upload_of(device.sim.activity, activity_)};
  for (const Upload& u : uploads) {
    if (u.bytes == 0) continue;
    const Status status = backend_.to_device(const_cast<void*>(u.to), u.from, u.bytes);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

template class ColliderInputs<float>;
template class ColliderInputs<double>;

}  // namespace weft::api
