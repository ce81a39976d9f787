#include "frame_output.h"

#include "mesh_frames.h"
#include "pictures.h"

#include "io/output_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace weft::tools {
bool FrameSettings::has(FrameFormat format) const {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

std::string frame_path(const std::string& folder, uint64_t number, const char* extension) {
  char name[48];
  std::snprintf(name, sizeof name, "frame_%06llu.%s", static_cast<unsigned long long>(number),
                extension);
  return (std::filesystem::path(folder) / name).string();
}

std::string film_path(const std::string& folder, const std::string& scene_file) {
  const std::string name = std::filesystem::path(scene_file).stem().string() + ".mp4";
  return (std::filesystem::path(folder) / name).string();
}

FrameOutput::FrameOutput(const FrameSettings& settings, const io::Scene& scene,
                         io::RunningScene& made)
    : clock_(settings.every, scene.time.frame),
      frame_seconds_(scene.time.frame),
      surface_(io::make_surface(scene, made)),
      scene_file_(scene.file) {
  const bool pictures = settings.has(FrameFormat::png) || settings.has(FrameFormat::mp4);
  if (pictures) require_pictures();
  if (pictures || settings.normals) surface_.normals.resize(surface_.positions.size());
  io::make_folder(settings.folder);
  io::probe_output(frame_path(settings.folder, 0, "probe"));
  const MeshFormat format{scene.solver.precision, settings.normals};
  if (settings.has(FrameFormat::obj)) sinks_.push_back(make_obj_frames(settings.folder, format));
  if (settings.has(FrameFormat::ply)) sinks_.push_back(make_ply_frames(settings.folder, format));
  read(made);
  if (pictures) {
    const PictureSettings about{settings.folder, settings.has(FrameFormat::png),
                                settings.has(FrameFormat::mp4), clock_.period()};
    sinks_.push_back(make_pictures(about, scene, surface_));
  }
  if (settings.has(FrameFormat::pc2)) {
    sinks_.push_back(make_point_caches(settings.folder, surface_, scene.solver.precision));
  }
}

bool FrameOutput::update(uint64_t frame, io::RunningScene& made) {
  if (!clock_.due(frame)) return false;
  read(made);
  const Frame now{surface_, written_++, double(frame) * frame_seconds_};
  for (const auto& sink : sinks_) sink->add(now);
  return true;
}

void FrameOutput::commit() {
  for (const auto& sink : sinks_) sink->commit();
}

void FrameOutput::read(io::RunningScene& made) {
  for (size_t i = 0; i < made.cloths.size(); ++i) {
    const size_t first = surface_.parts[i].first_vertex;
    const ClothId cloth = made.cloths[i];
    made.require(made.world.read_positions(cloth, &surface_.positions[first]), scene_file_);
    io::spread(made, i, &surface_.positions[first]);
    if (surface_.normals.empty()) continue;
    made.require(made.world.read_normals(cloth, &surface_.normals[first]), scene_file_);
    io::spread(made, i, &surface_.normals[first]);
  }
}

}  // namespace weft::tools
