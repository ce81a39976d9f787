// Something that takes the frames of a run: mesh files, point caches, pictures.
#pragma once

#include "io/surface.h"

#include <cstdint>
#include <string>

namespace weft::tools {

/// A moment of a run.
struct Frame {
  const io::Surface& surface;
  uint64_t number;  ///< of those that are written, from 0
  double time;      ///< s
};

class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void add(const Frame&) = 0;
  /// After the last one.
  virtual void commit() {}
};

/// FOLDER/frame_000012.EXTENSION
std::string frame_path(const std::string& folder, uint64_t number, const char* extension);
/// FOLDER/SCENE.mp4
std::string film_path(const std::string& folder, const std::string& scene_file);

}  // namespace weft::tools
