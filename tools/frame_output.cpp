#include "frame_output.h"

#include "mesh_frames.h"
#include "pictures.h"
#include "read_surface.h"

#include "io/output_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace weft::tools {
namespace {

bool has_pictures(const FrameSettings& settings) {
  return settings.has(FrameFormat::png) || settings.has(FrameFormat::mp4);
}

}  // namespace

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
                         io::Simulation& made, const ContextDesc& desc)
    : clock_(settings.every, scene.time.frame),
      frame_seconds_(scene.time.frame),
      normals_(settings.normals || has_pictures(settings)),
      surface_(io::make_surface(scene, made)),
      scene_file_(scene.file) {
  if (normals_) surface_.normals.resize(surface_.positions.size());
  if (has_pictures(settings)) require_pictures();
  io::make_folder(settings.folder);
  io::probe_output(frame_path(settings.folder, 0, "probe"));
  const MeshFormat format{scene.solver.precision, settings.normals};
  if (settings.has(FrameFormat::obj)) sinks_.push_back(make_obj_frames(settings.folder, format));
  if (settings.has(FrameFormat::ply)) sinks_.push_back(make_ply_frames(settings.folder, format));
  read(made);
  // Pictures first: no file is open while they rehearse.
  if (has_pictures(settings)) {
    const PictureSettings pictures{settings.folder, settings.has(FrameFormat::png),
                                   settings.has(FrameFormat::mp4), clock_};
    sinks_.push_back(make_pictures(pictures, scene, surface_, desc));
  }
  if (settings.has(FrameFormat::pc2)) {
    sinks_.push_back(make_point_caches(settings.folder, surface_, scene.solver.precision));
  }
}

bool FrameOutput::update(uint64_t frame, io::Simulation& made) {
  if (!clock_.due(frame)) return false;
  read(made);
  const Frame now{surface_, written_++, double(frame) * frame_seconds_};
  for (const auto& sink : sinks_) sink->add(now);
  return true;
}

void FrameOutput::commit() {
  for (const auto& sink : sinks_) sink->commit();
}

void FrameOutput::read(io::Simulation& made) { read_surface(made, scene_file_, surface_); }

}  // namespace weft::tools
