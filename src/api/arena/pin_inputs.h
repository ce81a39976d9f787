// What changes from frame to frame: moving pins and their motions. Staged on the host in
// memory that is sized when the arena is built, so that a step allocates nothing.
#pragma once

#include "api/arena/arena.h"
#include "base/memory_host.h"

namespace weft::api {

template <class T>
class PinInputs {
 public:
  explicit PinInputs(const Backend& backend) : backend_(backend) {}

  /// Gives a slot to every pin that can move, names their blocks in the image, and sizes the
  /// staging.
  void prepare(const ArenaInput&, const MovingPins<T>& image);
  /// Uploads the inputs of one frame.
  Status upload(const ArenaInput&, const FrameInput&, const MovingPins<T>& device);

 private:
  struct PinSlot {
    const ClothRecord* cloth;
    size_t pin;
    size_t slot;
  };

  void stage_pins();
  void stage_motions(const ArenaInput&, const FrameInput&);
  size_t vector_element(size_t slot, size_t component) const;

  const Backend& backend_;
  Vector<PinSlot> slots_;
  Vector<int32_t> motion_;
  Vector<T> base_, glide_;  ///< arrays of vectors in the back end's layout
  size_t pitch_ = 0;        ///< of both
  size_t motions_ = 0;
  Vector<Vec3<T>> offsets_;  ///< [substep][motion]
};

}  // namespace weft::api
