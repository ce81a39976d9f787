// Which frames of a run are written.
#pragma once

#include <cstdint>

namespace weft::tools {

/// The start, then a frame whenever `every` more seconds have passed.
class FrameClock {
 public:
  /// `every`: s; 0: each frame of the simulation.
  FrameClock(double every, double frame_seconds) : every_(every), frame_seconds_(frame_seconds) {}

  /// After `frame` frames of the simulation; to be asked once for each, in order.
  bool due(uint64_t frame) {
    if (frame == 0 || every_ <= frame_seconds_) return true;
    // A hair of a frame early counts: multiples of `every` and of the frame both carry rounding.
    const auto intervals = uint64_t((double(frame) + 1e-6) * frame_seconds_ / every_);
    if (intervals <= intervals_) return false;
    intervals_ = intervals;
    return true;
  }
  /// Seconds between frames that are written.
  double period() const { return every_ > frame_seconds_ ? every_ : frame_seconds_; }

 private:
  double every_, frame_seconds_;
  uint64_t intervals_ = 0;  ///< multiples of `every` that have been written
};

}  // namespace weft::tools
