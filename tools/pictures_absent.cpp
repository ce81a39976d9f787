#include "pictures.h"

#include "io/error.h"

namespace weft::tools {

void require_pictures() {
  throw io::UnavailableError(
      "pictures cannot be made (this program was built without libepoxy, EGL or libpng) install "
      "them, for example apt-get install libepoxy-dev libegl-dev libpng-dev, and build again, or "
      "write obj, ply or pc2");
}

std::unique_ptr<FrameSink> make_pictures(const PictureSettings&, const io::Scene&,
                                         const io::Surface&) {
  require_pictures();
  return nullptr;
}

}  // namespace weft::tools
