#include "frame_output.h"

#include "io/output_file.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace weft::tools {
namespace {

std::string frame_name(uint64_t number, const char* extension) {
  char name[48];
  std::snprintf(name, sizeof name, "frame_%06llu.%s", static_cast<unsigned long long>(number),
                extension);
  return name;
}

}  // namespace

FrameOutput::FrameOutput(const std::string& folder, FrameSettings settings, const io::Scene& scene,
                         const io::Simulation& made)
    : folder_(folder),
      settings_(std::move(settings)),
      frame_seconds_(scene.time.frame),
      precision_(scene.solver.precision),
      surface_(io::make_surface(scene, made)),
      scene_file_(scene.file) {
  if (settings_.normals) surface_.normals.resize(surface_.positions.size());
  io::make_folder(folder_);
  io::probe_output((std::filesystem::path(folder_) / frame_name(0, "probe")).string());
}

void FrameOutput::update(uint64_t frame, io::Simulation& made) {
  if (due(frame)) write(made);
}

bool FrameOutput::due(uint64_t frame) {
  const double every = settings_.every;
  if (frame == 0 || every == 0) return true;
  // A hair of a frame early counts: multiples of `every` and of the frame both carry rounding.
  const double time = (double(frame) + 1e-6) * frame_seconds_;
  if (every <= frame_seconds_) return true;
  const auto intervals = uint64_t(time / every);
  if (intervals <= intervals_) return false;
  intervals_ = intervals;
  return true;
}

void FrameOutput::write(io::Simulation& made) {
  for (size_t i = 0; i < made.cloths.size(); ++i) {
    const size_t first = surface_.parts[i].first_vertex;
    const ClothId cloth = made.cloths[i];
    made.require(made.world.read_positions(cloth, &surface_.positions[first]), scene_file_);
    if (!settings_.normals) continue;
    made.require(made.world.read_normals(cloth, &surface_.normals[first]), scene_file_);
  }
  const std::filesystem::path folder(folder_);
  for (const FrameFormat format : settings_.formats) {
    const bool obj = format == FrameFormat::obj;
    const std::string path = (folder / frame_name(written_, obj ? "obj" : "ply")).string();
    (obj ? io::write_obj : io::write_ply)(path, surface_, precision_);
  }
  ++written_;
}

}  // namespace weft::tools
