// The files of `run --out`.
#pragma once

#include "arguments.h"
#include "frame_clock.h"
#include "frame_sink.h"

#include "io/build.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace weft::tools {

/// What goes into the files, and how often.
struct FrameSettings {
  std::string folder;
  std::vector<FrameFormat> formats;
  double every = 0;  ///< seconds; 0: each frame of the simulation
  bool normals = false;

  bool has(FrameFormat) const;
};

/// Writes the start as frame 0, then a frame whenever `every` more seconds have passed, numbered
/// without gaps.
class FrameOutput {
 public:
  /// Makes the folder.
  FrameOutput(const FrameSettings&, const io::Scene&, io::RunningScene&);

  /// After `frame` frames of the simulation; true when it was due and is written.
  bool update(uint64_t frame, io::RunningScene&);
  void commit();

 private:
  void read(io::RunningScene&);  ///< positions and, where there is room for them, normals

  FrameClock clock_;
  double frame_seconds_;
  io::Surface surface_;
  std::string scene_file_;
  std::vector<std::unique_ptr<FrameSink>> sinks_;
  uint64_t written_ = 0;
};

}  // namespace weft::tools
