#include "api/arena/collider_inputs.h"

#include <algorithm>

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
Upload upload_of(const Element* to, const std::vector<Element>& from, size_t count) {
  return {to, from.data(), count * sizeof(Element)};
}
template <class Element>
Upload upload_of(const Element* to, const std::vector<Element>& from) {
  return upload_of(to, from, from.size());
}

}  // namespace

template <class T>
void ColliderInputs<T>::prepare(const ArenaInput& in, const plan::DeviceArrays<T>& image) {
  const Counts counts = plan::counts_of(in.shape);
  const size_t cloths = in.cloths.size(), colliders = size_t(counts.all_colliders);
  const auto staged = [&](ColliderShape shape) { return cloths * in.shape.colliders[int(shape)]; };
  spheres_.resize(staged(ColliderShape::sphere));
  planes_.resize(staged(ColliderShape::plane));
  capsules_.resize(staged(ColliderShape::capsule));
  cylinders_.resize(staged(ColliderShape::cylinder));
  boxes_.resize(staged(ColliderShape::box));
  meshes_.resize(staged(ColliderShape::mesh));
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
void ColliderInputs<T>::follow(const ArenaInput& in, const FrameInput& input) {
  followed_.clear();
  int32_t column = 0;
  for (int shape = 0; shape < collider_shapes; ++shape) {
    for (const ColliderRecord& c : *in.colliders) {
      if (!c.id || static_cast<int>(c.shape) != shape) continue;
      const ColliderPath path = path_of(c, input.time, input.substeps * input.dt);
      followed_.push_back({&c, path, swept_bounds(c, path), path.turns ? column : -1});
      if (c.can_turn) ++column;
    }
  }
}

template <class T>
void ColliderInputs<T>::stage_turns(const FrameInput& input) {
  for (const Followed& e : followed_) {
    if (e.turn < 0) continue;
    for (int s = 0; s <= input.substeps; ++s) {
      double3 rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      if (s > 0) turn_between(e.path.begin, e.path.end, double(s) / input.substeps, rows);
      Mat3<T>& to = turns_[size_t(s) * columns_ + size_t(e.turn)];
      for (int r = 0; r < 3; ++r) to.row[r] = narrow<T>(rows[r]);
    }
  }
}

template <class T>
Surface<T> ColliderInputs<T>::surface_of(const Followed& e, const double3& origin) const {
  return {narrow<T>(e.path.velocity), static_cast<T>(e.record->friction),
          static_cast<T>(e.record->sweep), e.turn,
          narrow<T>(minus(e.path.begin.translate, origin))};
}

/// One collider in the frame of a cloth; next[shape]: where the next of a shape goes.
template <class T>
void ColliderInputs<T>::stage(const Followed& e, const double3& origin, size_t* next) {
  const ColliderRecord& c = *e.record;
  const Placed& placed = e.path.begin;
  const auto along = [&](const double3& v) { return narrow<T>(rotate(placed.rows, v)); };
  const Vec3<T> at = narrow<T>(minus(to_world(placed, c.point), origin));
  const Surface<T> surface = surface_of(e, origin);
  const T size = static_cast<T>(c.size);
  const size_t i = next[static_cast<int>(c.shape)]++;
  switch (c.shape) {
    case ColliderShape::sphere:
      spheres_[i] = {at, size, surface};
      break;
    case ColliderShape::plane: {
      const double3 normal = rotate(placed.rows, c.point);
      const double offset = c.size + inner(normal, placed.translate) - inner(normal, origin);
      planes_[i] = {narrow<T>(normal), static_cast<T>(offset), surface};
      break;
    }
    case ColliderShape::capsule: {
      const double length2 = inner(c.axis, c.axis);
      const T inverse = static_cast<T>(length2 > 0 ? 1 / length2 : 0);
      capsules_[i] = {at, along(c.axis), inverse, size, along(c.side), surface};
      break;
    }
    case ColliderShape::cylinder:
      cylinders_[i] = {at, along(c.axis), static_cast<T>(c.length), size, along(c.side), surface};
      break;
    case ColliderShape::box:
      boxes_[i] = {at,
                   {along(c.edges[0]), along(c.edges[1]), along(c.edges[2])},
                   narrow<T>(c.half),
                   surface};
      break;
    case ColliderShape::mesh:
      meshes_[i].rotation = {
          {narrow<T>(placed.rows[0]), narrow<T>(placed.rows[1]), narrow<T>(placed.rows[2])}};
      meshes_[i].translate = narrow<T>(minus(placed.translate, origin));
      meshes_[i].surface = surface;
      break;
  }
}

/// Lists the colliders that a cloth can touch, at near_[first] and on; returns how many.
template <class T>
size_t ColliderInputs<T>::find_near(const ClothRecord& cloth, double margin, size_t first,
                                    ClothActivity<T>& activity) {
  // Rounding to T must not take anything off the list.
  const double slack = 1e-6 * (length(cloth.low) + length(cloth.high)) + 1e-9;
  const double3 low = plus(box_low(cloth.low, margin + slack), cloth.origin);
  const double3 high = plus(box_high(cloth.high, margin + slack), cloth.origin);
  size_t next = first, seen[collider_shapes] = {};
  for (int shape = 0; shape < collider_shapes; ++shape) {
    activity.near_first[shape] = static_cast<int>(next);
    for (const Followed& e : followed_) {
      if (static_cast<int>(e.record->shape) != shape) continue;
      const size_t index = seen[shape]++;
      if (!overlaps(low, high, e.bounds)) continue;
      near_[next] = static_cast<int32_t>(index);
      const SweptBounds& r = e.bounds;
      near_bounds_[next] = {narrow<T>(box_low(minus(r.low, cloth.origin), slack)),
                            narrow<T>(box_high(minus(r.high, cloth.origin), slack)),
                            narrow<T>(minus(r.center, cloth.origin)),
                            static_cast<T>((r.radius + slack) * (r.radius + slack)),
                            narrow<T>(r.normal),
                            static_cast<T>(r.offset - inner(r.normal, cloth.origin) + slack)};
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
  const size_t near = find_near(cloth, margin, first_near, activity);
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
  follow(in, input);
  stage_turns(input);
  size_t next[collider_shapes] = {};
  const double gravity = length(in.world->gravity);
  for (size_t c = 0; c < in.cloths.size(); ++c) {
    for (const Followed& e : followed_) stage(e, in.cloths[c]->origin, next);
    stage_activity(*in.cloths[c], input, gravity, c * followed_.size(), activity_[c]);
  }
  for (size_t i = 0, of = 0; i < meshes_.size(); ++i, ++of) {
    if (of == in.mesh_of_collider.size()) of = 0;
    const size_t m = in.mesh_of_collider[of];
    meshes_[i].grid = device.meshes[m];
    set_numbers(*in.meshes[m], meshes_[i].grid);
  }

  const Colliders<T>& to = device.sim.colliders;
  const size_t turns = columns_ > 0 ? columns_ * (size_t(input.substeps) + 1) : 0;
  const Upload uploads[] = {upload_of(to.spheres, spheres_),
                            upload_of(to.planes, planes_),
                            upload_of(to.capsules, capsules_),
                            upload_of(to.cylinders, cylinders_),
                            upload_of(to.boxes, boxes_),
                            upload_of(to.meshes, meshes_),
                            upload_of(to.turn, turns_, turns),
                            upload_of(to.near, near_),
                            upload_of(to.near_bounds, near_bounds_),
                            upload_of(device.sim.activity, activity_)};
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
