#include "output_paths.h"

#include "cache_names.h"

#include "io/error.h"
#include "io/output_file.h"
#include "io/text_cursor.h"

#include <filesystem>

namespace weft::tools {
namespace {

namespace fs = std::filesystem;

/// The same for all ways to write a path.
fs::path resolved(const fs::path& path) {
  std::error_code failure;
  const fs::path target = io::follow_links(path.string());
  const fs::path found = fs::weakly_canonical(fs::absolute(target, failure), failure);
  return failure ? path : found;
}

/// Standard output or /dev/null take any number of writers.
bool is_device(const fs::path& path) {
  std::error_code failure;
  return fs::is_other(path, failure);
}

[[noreturn]] void refuse(const std::string& option, const std::string& path,
                         const std::string& what) {
  throw io::InputError(option + ": " + io::quoted(path) + " is also " + what +
                       " (one would replace the other) give another path");
}

bool is_frame(const fs::path& file, const FrameSettings& settings) {
  const std::string extension = file.extension().string();
  return is_frame_stem(file.stem().string()) &&
         ((extension == ".obj" && settings.has(FrameFormat::obj)) ||
          (extension == ".ply" && settings.has(FrameFormat::ply)) ||
          (extension == ".png" && settings.has(FrameFormat::png)));
}

// Through a link, a frame would be written over the scene, or over another frame; a folder or a
// pipe takes none.
void require_file(const fs::path& path) {
  std::error_code none;
  const fs::file_status there = fs::symlink_status(path, none);
  if (!fs::exists(there) || fs::is_regular_file(there)) return;
  throw io::InputError("--out: " + io::quoted(path.string()) + " is " +
                       (fs::is_symlink(there) ? "a symbolic link" : "not a file") +
                       " (frames become files of that name) remove it, or give another folder");
}

}  // namespace

OutputPaths::OutputPaths(const io::Scene& scene) {
  for (const std::string& file : scene.meshes) {
    taken_[resolved(file).string()] = "a mesh that the scene reads";
  }
  taken_[resolved(scene.file).string()] = "the scene";
}

void OutputPaths::add(const std::string& option, const std::string& path) {
  if (path.empty() || is_device(path)) return;
  const auto [place, is_new] = taken_.emplace(resolved(path).string(), "the file of " + option);
  if (!is_new) refuse(option, path, place->second);
}

void OutputPaths::add_frames(const FrameSettings& settings, const io::Scene& scene) {
  const fs::path folder = settings.folder;
  const std::string there = resolved(folder).string();
  for (const auto& [path, what] : taken_) {
    const fs::path file = path;
    if (file.parent_path() != there || !is_frame(file, settings)) continue;
    refuse("--out", (folder / file.filename()).string(), what);
  }
  for (fs::path above = there; above != above.root_path(); above = above.parent_path()) {
    const auto file = taken_.find(above.string());
    if (file != taken_.end()) refuse("--out", settings.folder, file->second);
  }
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (is_frame(entry.path(), settings)) require_file(entry.path());
  }
  if (settings.has(FrameFormat::pc2)) {
    std::vector<std::string> cloths;
    for (const io::ClothScene& cloth : scene.cloths) cloths.push_back(cloth.name);
    for (const std::string& name : cache_names(cloths)) {
      for (const char* extension : {".obj", ".pc2"}) {
        require_file(folder / (name + extension));
        add("--out", (folder / (name + extension)).string());
      }
    }
  }
  if (settings.has(FrameFormat::mp4)) {
    const std::string film = film_path(settings.folder, scene.file);
    require_file(film);
    add("--out", film);
  }
}

}  // namespace weft::tools
