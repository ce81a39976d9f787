#include "render/image.h"

#include "io/error.h"
#include "io/output_file.h"

#include <png.h>

namespace weft::render {

void write_png(const std::string& path, const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width;
  png.height = image.height;
  png.format = PNG_FORMAT_RGB;
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::vector<uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t size = bytes.size();
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr)) {
    throw io::OutputError(path + ": cannot be encoded (" + png.message + ") give another format");
  }
  io::OutputFile file(path);
  file.write(bytes.data(), size);
  file.commit();
}

}  // namespace weft::render
