// The files of `run --out`: DIR/frame_000000.obj, ...
#pragma once

#include "arguments.h"

#include "io/build.h"

#include <cstdint>
#include <string>
#include <vector>

namespace weft::tools {

/// What goes into the files, and how often.
struct FrameSettings {
  std::vector<FrameFormat> formats;
  double every = 0;  ///< seconds; 0: each frame of the simulation
  bool normals = false;
};

/// Writes the start as frame 0, then a frame whenever `every` more seconds have passed, numbered
/// without gaps.
class FrameOutput {
 public:
  /// Makes the folder.
  FrameOutput(const std::string& folder, FrameSettings, const io::Scene&, const io::Simulation&);

  /// After `frame` frames of the simulation; writes if one is due.
  void update(uint64_t frame, io::Simulation&);

 private:
  bool due(uint64_t frame);
  void write(io::Simulation&);

  std::string folder_;
  FrameSettings settings_;
  double frame_seconds_;
  Precision precision_;
  io::Surface surface_;
  std::string scene_file_;
  uint64_t written_ = 0;
  uint64_t intervals_ = 0;  ///< multiples of `every` that have been written
};

}  // namespace weft::tools
