#include "pictures.h"

#include "output.h"
#include "read_surface.h"
#include "stop_signal.h"

#include "io/error.h"
#include "io/text_cursor.h"

#include "render/painter.h"
#include "render/session.h"
#include "render/sight.h"
#include "render/video.h"
#include "render/yielding_mesh.h"

#include <optional>

namespace weft::tools {
namespace {

/// What will be seen.
struct Views {
  Views(const io::Scene& scene, const io::Surface& start)
      : framing(scene, start), reach(scene, start), sight(scene, framing) {
    reach.add(start, 0);
    sight.add(start);
  }
  void add(const io::Surface& surface, double time) {
    framing.add(surface);
    reach.add(surface, time);
    sight.add(surface);
  }

  render::Framing framing;
  render::Reach reach;
  render::Sight sight;
};

/// By running the scene once. What goes wrong in it will be told by the run.
Views rehearse(const io::Scene& scene, const io::Surface& start, FrameClock clock,
               const ContextDesc& desc) {
  const LongWork work("the rehearsal for pictures");
  Views views(scene, start);
  io::Simulation made = io::build(scene, desc);
  io::Surface surface = io::make_surface(scene, made);
  const uint64_t count = io::frame_count(scene.time, "$.time.duration");
  for (uint64_t frame = 1; frame <= count && stop_signal() == 0; ++frame) {
    if (made.world.step(scene.time.frame) != Status::ok) break;
    if (!clock.due(frame)) continue;
    read_surface(made, scene.file, surface);
    views.add(surface, double(frame) * scene.time.frame);
  }
  for (const std::string& problem : views.sight.problems(views.framing)) {
    print_message("warning: " + scene.file + ": " + problem);
  }
  for (const std::string& problem : views.reach.problems()) {
    print_message("warning: " + scene.file + ": " + problem);
  }
  return views;
}

class Pictures final : public FrameSink {
 public:
  Pictures(const PictureSettings& settings, const io::Scene& scene, const io::Surface& start,
           const Views& views)
      : folder_(settings.folder),
        scene_file_(scene.file),
        png_(settings.png),
        painter_(scene, start, views.framing, views.reach) {
    if (!settings.mp4) return;
    video_.emplace(film_path(folder_, scene.file), scene.camera.width, scene.camera.height,
                   1 / settings.clock.period());
  }

  void add(const Frame& frame) override {
    const render::Image image = painter_.draw(frame.surface, frame.time);
    if (png_) render::write_png(frame_path(folder_, frame.number, "png"), image);
    if (video_) video_->add(image);
  }
  void commit() override {
    if (video_) video_->commit();
    for (const std::string& problem : painter_.problems()) {
      print_message("warning: " + scene_file_ + ": " + problem);
    }
  }

 private:
  std::string folder_, scene_file_;
  bool png_;
  render::Session session_;  // the painter needs it
  render::Painter painter_;
  std::optional<render::Video> video_;
};

}  // namespace

void require_pictures() { const render::Session session; }

uint64_t bytes_for_pictures(const io::Scene& scene) { return render::bytes_of_meshes(scene); }

std::unique_ptr<FrameSink> make_pictures(const PictureSettings& settings, const io::Scene& scene,
                                         const io::Surface& start, const ContextDesc& desc) {
  constexpr double longest = 3600;  // ffmpeg does not take much more
  if (settings.mp4 && settings.clock.period() > longest) {
    throw io::InputError("--every: " + io::number_text(settings.clock.period()) +
                         " s between the pictures of a film are too many (it shows one for an hour "
                         "at most) give less, or write png");
  }
  if (settings.mp4) render::require_films(film_path(settings.folder, scene.file));
  const Views views = rehearse(scene, start, settings.clock, desc);
  return std::make_unique<Pictures>(settings, scene, start, views);
}

}  // namespace weft::tools
