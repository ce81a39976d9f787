// A picture in memory, and as a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace weft::render {

/// 8-bit sRGB, three bytes per pixel, rows from the top.
struct Image {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgb;
};

/// Appears whole or not at all. OutputError when it cannot be written.
void write_png(const std::string& path, const Image&);

}  // namespace weft::render
