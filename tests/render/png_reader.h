// Pictures from files, and how alike two are.
#pragma once

#include "render/image.h"

#include <string>

namespace weft::render::test {

/// Width 0 when the file cannot be read.
Image read_png(const std::string& path);

/// Peak signal-to-noise ratio of two pictures of one size, dB; infinite where they are equal.
double psnr(const Image& a, const Image& b);

}  // namespace weft::render::test
