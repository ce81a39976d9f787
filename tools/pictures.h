// Frames as pictures and as a film. In a build without OpenGL, pictures_absent.cpp says so.
#pragma once

#include "frame_sink.h"

#include "io/scene.h"

#include <memory>
#include <string>

namespace weft::tools {

struct PictureSettings {
  std::string folder;
  bool png, mp4;  ///< FOLDER/frame_000000.png, ... and FOLDER/SCENE.mp4
  double period;  ///< s from picture to picture
};

/// UnavailableError where no picture can be made.
void require_pictures();

/// `start`: with normals.
std::unique_ptr<FrameSink> make_pictures(const PictureSettings&, const io::Scene&,
                                         const io::Surface& start);

}  // namespace weft::tools
