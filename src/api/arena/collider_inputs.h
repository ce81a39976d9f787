// Colliders of a frame: staged in each cloth's frame, with the list of those that it can touch.
#pragma once

#include "api/arena/arena.h"
#include "base/memory_host.h"
#include "plan/device_arrays.h"

namespace weft::api {

template <class T>
class ColliderInputs {
 public:
  explicit ColliderInputs(const Backend& backend) : backend_(backend) {}

  /// Sizes the staging and writes what never changes to the image.
  void prepare(const ArenaInput&, const plan::DeviceArrays<T>& image);
  /// Uploads the inputs of one frame.
  Status upload(const ArenaInput&, const FrameInput&, const plan::DeviceArrays<T>& device);
  /// Whether any cloth's blocks have lists of their own in the frame uploaded last.
  bool by_block() const { return by_block_; }

 private:
  struct Followed {
    const ColliderRecord* record;
    ColliderPath path;
    SweptBounds bounds;
    int32_t turn;
    double slack;  ///< m: what rounding to T may take off the bounds
  };

  void follow(const ArenaInput&, const FrameInput&, const plan::DeviceArrays<T>& device);
  void stage_turns(const FrameInput&);
  void see(const Followed&, const ArenaInput&, const plan::DeviceArrays<T>& device);
  Plane<T> plane_of(const Followed&, const double3& origin, double dt) const;
  void place_all(const ClothRecord&, double dt, size_t cloth);
  void stage_activity(const ClothRecord&, const FrameInput&, double gravity, size_t first_near,
                      ClothActivity<T>&);
  size_t find_near(const ClothRecord&, double margin, double dt, size_t first, ClothActivity<T>&);

  /// A shape as every cloth sees it, but for where its origin is.
  template <class Shape>
  struct Seen {
    Shape shape;
    double3 at, pivot;  ///< in the world
    const ColliderRecord* record;
  };
  template <class Shape>
  struct Staged {
    Vector<Seen<Shape>> seen;
    Vector<Shape> all;  ///< [cloth][collider]; those that a cloth may not meet have left no gap
    void place(const ClothRecord&, size_t cloth);
  };

  const Backend& backend_;
  Vector<Followed> followed_;  ///< by shape, then by slot: the order in which they are met
  Staged<Sphere<T>> spheres_;
  Vector<Plane<T>> planes_;
  Staged<Capsule<T>> capsules_;
  Staged<Cylinder<T>> cylinders_;
  Staged<Box<T>> boxes_;
  Staged<MeshCollider<T>> meshes_;
  Vector<Mat3<T>> turns_;  ///< [substep + 1][column]
  Vector<int32_t> near_;
  Vector<ColliderBounds<T>> near_bounds_;
  Vector<ClothActivity<T>> activity_;
  size_t columns_ = 0;
  bool by_block_ = false;
};

}  // namespace weft::api
