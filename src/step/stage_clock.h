// Where the time of a frame goes, for those who ask.
#pragma once

namespace weft {

/// The parts of a frame between which all threads meet (step/pipeline.h).
enum class Lap : int { reach, springs, hubs, sums, advance, survey, contacts };
constexpr int lap_count = 7;

/// Seconds of each since the clock was made; one thread of the team keeps it.
struct StageClock {
  double last = 0;
  double seconds[lap_count] = {};
};

}  // namespace weft
