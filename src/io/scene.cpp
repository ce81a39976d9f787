#include "io/scene.h"

#include "io/error.h"
#include "io/file_text.h"
#include "io/scene_parts.h"
#include "io/text_cursor.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace weft::io {
namespace {

void read_version(const Node& version) {
  if (version.integer(1, INT64_MAX, "versions start at 1") != 1) {
    version.out_of_range("this program reads version 1", "give 1");
  }
}

void read_root(const Node& root, Scene& scene, MeshCache& meshes) {
  root.require_object({"weft", "gravity", "time", "solver", "cloths", "colliders", "wind",
                       "self_collision", "camera"});
  read_version(root.at("weft", "the format version, 1"));
  if (const auto node = root.find("gravity")) scene.gravity = node->vector();
  if (const auto node = root.find("time")) read_time(*node, scene.time);
  if (const auto node = root.find("solver")) read_solver(*node, scene.solver);
  const Node cloths = root.at("cloths", "an array of at least one cloth");
  const size_t count = cloths.array_size("an array of cloths");
  if (count == 0) cloths.fail("is empty (a scene needs at least one cloth) add one");
  for (size_t i = 0; i < count; ++i) scene.cloths.push_back(read_cloth(cloths[i], meshes));
  if (const auto colliders = root.find("colliders")) {
    const size_t colliders_count = colliders->array_size("an array of colliders");
    for (size_t i = 0; i < colliders_count; ++i) {
      scene.colliders.push_back(read_collider((*colliders)[i], meshes));
    }
  }
  if (const auto node = root.find("wind")) scene.wind = read_wind(*node);
  if (const auto node = root.find("self_collision")) {
    scene.self_collision = read_self_collision(*node);
  }
  if (const auto node = root.find("camera")) scene.camera = read_camera(*node);
}

}  // namespace

Scene read_scene(const std::string& path) {
  return read_scene_text(read_file(path, largest_scene_file()).view(), path);
}

Scene read_scene_text(std::string_view text, const std::string& path) {
  const Json json = parse_json(text, path);
  Scene scene;
  scene.file = path;
  MeshCache meshes{std::filesystem::path(path).parent_path().string(), {}, 0};
  try {
    read_root(Node(json), scene, meshes);
    for (const auto& [file, mesh] : meshes.meshes) scene.meshes.push_back(file);
    frame_count(scene.time, "$.time.duration");
    refuse_unavailable(scene);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  return scene;
}

uint32_t vertex_count(const Shape& shape) {
  if (const auto* grid = std::get_if<GridShape>(&shape)) return grid->rows * grid->columns;
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    return uint32_t(mesh->mesh->positions.size());
  }
  return uint32_t(std::get<NetworkShape>(shape).positions.size());
}

uint64_t frame_count(const TimeSettings& time, const std::string& path) {
  const double frames = std::ceil(time.duration / time.frame - 1e-6);
  if (!(frames <= 9007199254740992.0)) {
    throw InputError(path + ": " + number_text(time.duration) +
                     " is out of range (with a frame of " + number_text(time.frame) + " s it has " +
                     number_text(frames) + " frames) give at most 2^53 frames");
  }
  return uint64_t(std::max(frames, 0.0));
}

}  // namespace weft::io
