#include "api/frame_inputs.h"

#include <algorithm>

#include "api/arena_fill.h"

namespace weft::api {

template <class T>
size_t FrameInputs<T>::vector_element(size_t slot, size_t component,
                                      const plan::VectorArray& array) const {
  return slot * static_cast<size_t>(backend_.info().particle_step) + component * array.pitch;
}

template <class T>
void FrameInputs<T>::prepare(const ArenaInput& in, const plan::Layout& layout, char* image) {
  const size_t cloths = in.cloths.size();
  spheres_.resize(cloths * in.shape.colliders_of(ColliderShape::sphere));
  planes_.resize(cloths * in.shape.colliders_of(ColliderShape::plane));
  capsules_.resize(cloths * in.shape.colliders_of(ColliderShape::capsule));
  cylinders_.resize(cloths * in.shape.colliders_of(ColliderShape::cylinder));
  boxes_.resize(cloths * in.shape.colliders_of(ColliderShape::box));
  slots_.clear();
  if (layout.block_pins == plan::absent) return;
  auto* of_block = reinterpret_cast<int32_t*>(image + layout.block_pins);
  std::fill_n(of_block, in.shape.blocks(), -1);
  int next = 0;
  for (const ClothRecord* cloth : in.cloths) {
    for (size_t p = 0; p < cloth->pins.size(); ++p) {
      if (!cloth->pins[p].can_move) continue;
      const int i = cloth->first + static_cast<int>(cloth->cooked().storage(cloth->pins[p].vertex));
      int32_t& block = of_block[i / block_size];
      if (block < 0) block = next++;
      slots_.push_back({cloth, p, static_cast<size_t>(block * block_size + i % block_size)});
    }
  }
  const size_t elements = static_cast<size_t>(next) * block_size;
  array_ = layout.pin_base;
  motion_.assign(elements, -1);
  base_.assign(vector_element(elements - 1, 2, array_) + 1, T(0));
  glide_.assign(base_.size(), T(0));
  offsets_.resize(size_t(in.shape.motions) * in.shape.substeps);
}

template <class T>
Status FrameInputs<T>::upload(const ArenaInput& in, const FrameInput& input,
                              const plan::Layout& layout, char* base) {
  const Status status = upload_colliders(in, input.time, layout, base);
  return status == Status::ok ? upload_pins(in, input, layout, base) : status;
}

/// One collider at `time`, in the frame of a cloth; next[shape]: where the next of a shape goes.
template <class T>
void FrameInputs<T>::stage_collider(const ColliderRecord& c, double time, const double3& origin,
                                    size_t* next) {
  const double3 moved = times(time - c.since, c.velocity);
  const Vec3<T> at = narrow<T>(minus(plus(c.point, moved), origin));
  const Surface<T> surface{narrow<T>(c.velocity), static_cast<T>(c.friction)};
  const T size = static_cast<T>(c.size);
  const size_t i = next[static_cast<int>(c.shape)]++;
  switch (c.shape) {
    case ColliderShape::sphere:
      spheres_[i] = {at, size, surface};
      break;
    case ColliderShape::plane: {
      const double offset = c.size + inner(c.point, moved) - inner(c.point, origin);
      planes_[i] = {narrow<T>(c.point), static_cast<T>(offset), surface};
      break;
    }
    case ColliderShape::capsule: {
      const double length2 = inner(c.axis, c.axis);
      const T inverse = static_cast<T>(length2 > 0 ? 1 / length2 : 0);
      capsules_[i] = {at, narrow<T>(c.axis), inverse, size, narrow<T>(c.side), surface};
      break;
    }
    case ColliderShape::cylinder:
      cylinders_[i] = {at,   narrow<T>(c.axis), static_cast<T>(c.length),
                       size, narrow<T>(c.side), surface};
      break;
    case ColliderShape::box:
      boxes_[i] = {at,
                   {narrow<T>(c.edges[0]), narrow<T>(c.edges[1]), narrow<T>(c.edges[2])},
                   narrow<T>(c.half),
                   surface};
      break;
  }
}

/// Colliders at the start of the frame, in each cloth's own frame.
template <class T>
Status FrameInputs<T>::upload_colliders(const ArenaInput& in, double time,
                                        const plan::Layout& layout, char* base) {
  size_t next[collider_shapes] = {};
  for (const ClothRecord* cloth : in.cloths) {
    for (const ColliderRecord& c : *in.colliders) {
      if (c.id) stage_collider(c, time, cloth->origin, next);
    }
  }
  const struct {
    const void* data;
    size_t bytes;
  } staged[collider_shapes] = {{spheres_.data(), spheres_.size() * sizeof(Sphere<T>)},
                               {planes_.data(), planes_.size() * sizeof(Plane<T>)},
                               {capsules_.data(), capsules_.size() * sizeof(Capsule<T>)},
                               {cylinders_.data(), cylinders_.size() * sizeof(Cylinder<T>)},
                               {boxes_.data(), boxes_.size() * sizeof(Box<T>)}};
  for (int shape = 0; shape < collider_shapes; ++shape) {
    if (staged[shape].bytes == 0) continue;
    const Status status =
        backend_.to_device(base + layout.colliders[shape], staged[shape].data, staged[shape].bytes);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

template <class T>
void FrameInputs<T>::stage_pins() {
  for (const PinSlot& s : slots_) {
    const PinRecord& pin = s.cloth->pins[s.pin];
    const Vec3<T> at = narrow<T>(minus(pin.base, s.cloth->origin));
    const Vec3<T> by = narrow<T>(pin.gliding ? minus(pin.target, pin.base) : double3{0, 0, 0});
    const T base[3] = {at.x, at.y, at.z}, glide[3] = {by.x, by.y, by.z};
    for (size_t c = 0; c < 3; ++c) {
      base_[vector_element(s.slot, c, array_)] = base[c];
      glide_[vector_element(s.slot, c, array_)] = glide[c];
    }
    motion_[s.slot] = pin.motion < 0 ? 0 : s.cloth->motion_first + pin.motion;
  }
}

/// Motion 0 stands for none.
template <class T>
void FrameInputs<T>::stage_motions(const ArenaInput& in, const FrameInput& input) {
  for (int k = 0; k < input.substeps; ++k) {
    Vec3<T>* row = offsets_.data() + size_t(k) * in.shape.motions;
    row[0] = {T(0), T(0), T(0)};
    const double time = input.time + (k + 1) * input.dt;
    for (const ClothRecord* cloth : in.cloths) {
      for (size_t m = 0; m < cloth->motions.size(); ++m) {
        row[size_t(cloth->motion_first) + m] = narrow<T>(motion_offset(cloth->motions[m], time));
      }
    }
  }
}

template <class T>
Status FrameInputs<T>::upload_pins(const ArenaInput& in, const FrameInput& input,
                                   const plan::Layout& layout, char* base) {
  if (slots_.empty()) return Status::ok;
  stage_pins();
  stage_motions(in, input);
  const struct {
    size_t offset;
    const void* from;
    size_t bytes;
  } parts[] = {
      {layout.pin_base.offset, base_.data(), base_.size() * sizeof(T)},
      {layout.pin_glide.offset, glide_.data(), glide_.size() * sizeof(T)},
      {layout.pin_motion, motion_.data(), motion_.size() * sizeof(int32_t)},
      {layout.pin_offset, offsets_.data(),
       size_t(input.substeps) * in.shape.motions * sizeof(Vec3<T>)},
  };
  for (const auto& part : parts) {
    const Status status = backend_.to_device(base + part.offset, part.from, part.bytes);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

template class FrameInputs<float>;
template class FrameInputs<double>;

}  // namespace weft::api
