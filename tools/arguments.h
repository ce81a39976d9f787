// Words of the command line to values. Failures are InputErrors that name the option.
#pragma once

#include "weft/context.hpp"

#include "options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace weft::tools {

/// The command line is wrong: exit code 2, like a wrong scene.
[[noreturn]] void bad_argument(const std::string& option, const std::string& value,
                               const std::string& why, const std::string& remedy);

/// A finite number; with `positive` above zero, else at least zero.
double seconds_argument(const std::string& option, const std::string& text, bool positive);

struct PictureSize {
  uint32_t width, height;
};
/// "640x360"; sides as in a scene's camera.
PictureSize size_argument(const std::string& option, const std::string& text);

/// Where a command runs.
ContextDesc context_desc(const CommonOptions&);

enum class FrameFormat : unsigned char { obj, ply, pc2, png, mp4 };
/// "obj,ply" to formats, each once.
std::vector<FrameFormat> frame_formats(const std::string& list);

}  // namespace weft::tools
