// What changes from frame to frame: colliders, moving pins and their motions. Staged on the host in
// memory that is sized when the arena is built, so that a step allocates nothing.
#pragma once

#include "api/arena.h"

namespace weft::api {

template <class T>
class FrameInputs {
 public:
  explicit FrameInputs(const Backend& backend) : backend_(backend) {}

  /// Gives a slot to every pin that can move, names their blocks in the image, and sizes the
  /// staging.
  void prepare(const ArenaInput&, const plan::Layout&, char* image);
  /// Uploads the inputs of one frame to device memory at `base`.
  Status upload(const ArenaInput&, const FrameInput&, const plan::Layout&, char* base);

 private:
  struct PinSlot {
    const ClothRecord* cloth;
    size_t pin;
    size_t slot;
  };

  Status upload_colliders(const ArenaInput&, double time, const plan::Layout&, char* base);
  void stage_collider(const ColliderRecord&, double time, const double3& origin, size_t* next);
  Status upload_pins(const ArenaInput&, const FrameInput&, const plan::Layout&, char* base);
  void stage_pins();
  void stage_motions(const ArenaInput&, const FrameInput&);
  size_t vector_element(size_t slot, size_t component, const plan::VectorArray&) const;

  const Backend& backend_;
  std::vector<Sphere<T>> spheres_;
  std::vector<Plane<T>> planes_;
  std::vector<Capsule<T>> capsules_;
  std::vector<Cylinder<T>> cylinders_;
  std::vector<Box<T>> boxes_;
  std::vector<PinSlot> slots_;
  std::vector<int32_t> motion_;
  std::vector<T> base_, glide_;   ///< arrays of vectors in the back end's layout
  std::vector<Vec3<T>> offsets_;  ///< [substep][motion]
  plan::VectorArray array_;       ///< layout of base_ and glide_
};

}  // namespace weft::api
