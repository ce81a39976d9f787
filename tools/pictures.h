// Frames as pictures and as a film. In a build without OpenGL, pictures_absent.cpp says so.
#pragma once

#include "frame_clock.h"
#include "frame_sink.h"

#include "io/build.h"

#include <memory>
#include <string>

namespace weft::tools {

struct PictureSettings {
  std::string folder;
  bool png, mp4;  ///< FOLDER/frame_000000.png, ... and FOLDER/SCENE.mp4
  FrameClock clock;
};

/// UnavailableError where no picture can be made.
void require_pictures();

/// What pictures take beyond the second world.
uint64_t bytes_for_pictures(const io::Scene&);

/// `start`: with normals. The camera has to know where the cloths will go, so that the scene is run
/// once before, in a world of its own.
std::unique_ptr<FrameSink> make_pictures(const PictureSettings&, const io::Scene&,
                                         const io::Surface& start, const ContextDesc&);

}  // namespace weft::tools
