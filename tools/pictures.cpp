#include "pictures.h"

#include "io/error.h"
#include "io/text_cursor.h"

#include "render/painter.h"
#include "render/session.h"
#include "render/video.h"

#include <optional>

namespace weft::tools {
namespace {

class Pictures final : public FrameSink {
 public:
  Pictures(const PictureSettings& settings, const io::Scene& scene, const io::Surface& start)
      : folder_(settings.folder), png_(settings.png), painter_(scene, start) {
    if (!settings.mp4) return;
    video_.emplace(film_path(folder_, scene.file), scene.camera.width, scene.camera.height,
                   1 / settings.period);
  }

  void add(const Frame& frame) override {
    const render::Image image = painter_.draw(frame.surface, frame.time);
    if (png_) render::write_png(frame_path(folder_, frame.number, "png"), image);
    if (video_) video_->add(image);
  }
  void commit() override {
    if (video_) video_->commit();
  }

 private:
  std::string folder_;
  bool png_;
  render::Session session_;  // the painter needs it
  render::Painter painter_;
  std::optional<render::Video> video_;
};

}  // namespace

void require_pictures() { const render::Session session; }

std::unique_ptr<FrameSink> make_pictures(const PictureSettings& settings, const io::Scene& scene,
                                         const io::Surface& start) {
  constexpr double longest = 3600;  // ffmpeg does not take much more
  if (settings.mp4 && settings.period > longest) {
    throw io::InputError("--every: " + io::number_text(settings.period) +
                         " s between the pictures of a film are too many (it shows one for an hour "
                         "at most) give less, or write png");
  }
  return std::make_unique<Pictures>(settings, scene, start);
}

}  // namespace weft::tools
