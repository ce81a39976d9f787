// An input that an engine gives once a frame, and the steps inside of the frame that find it on its
// way: it is at `from` when the frame begins and at `to` when it ends.
#pragma once

#include <cstdint>

namespace weft::api {

template <class Place>
struct Way {
  enum class State : uint8_t {
    none,   ///< at rest: nothing to do
    given,  ///< since the last frame
    late    ///< its frame is over, but no step has reached its end yet
  };
  State state = State::none;
  Place from{}, to{};

  /// `here`: where it is, if it is at rest. What is given twice in a frame counts once.
  void give(const Place& here, const Place& place) {
    if (state == State::none) from = here;
    if (state == State::late) from = to;
    to = place;
    state = State::given;
  }
  /// The frame is over.
  void hold() {
    if (state != State::given) return;
    from = to;
    state = State::late;
  }
  void arrive() { state = State::none; }
};

}  // namespace weft::api
