#include "mesh_frames.h"

#include "cache_names.h"
#include "output.h"

#include "io/error.h"
#include "io/point_cache.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace weft::tools {
namespace {

using Write = void (*)(const std::string&, const io::Surface&, Precision, bool);

/// Floats within 16 m of zero are positions to a micrometre. Farther out a cloth, which counts from
/// an origin of its own, is finer than they are.
Precision fine_enough(const io::Surface& surface, Precision precision) {
  constexpr double fine_within = 16;
  for (const double3& p : surface.positions) {
    const double most = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (most > fine_within) return Precision::float64;
  }
  return precision;
}

class MeshFrames final : public FrameSink {
 public:
  MeshFrames(std::string folder, const char* extension, Write write, MeshFormat format)
      : folder_(std::move(folder)), extension_(extension), write_(write), format_(format) {}

  void add(const Frame& frame) override {
    write_(frame_path(folder_, frame.number, extension_), frame.surface,
           fine_enough(frame.surface, format_.precision), format_.normals);
  }

 private:
  std::string folder_;
  const char* extension_;
  Write write_;
  MeshFormat format_;
};

/// One cloth as a surface of its own.
io::Surface part_of(const io::Surface& whole, const io::SurfacePart& part) {
  const auto first = uint32_t(part.first_vertex);
  io::Surface alone;
  const auto positions = whole.positions.begin() + ptrdiff_t(first);
  alone.positions.assign(positions, positions + ptrdiff_t(part.vertex_count));
  for (size_t i = 0; i < part.triangle_count; ++i) {
    const auto& t = whole.triangles[part.first_triangle + i];
    alone.triangles.push_back({t[0] - first, t[1] - first, t[2] - first});
  }
  for (size_t i = 0; i < part.edge_count; ++i) {
    const auto& e = whole.edges[part.first_edge + i];
    alone.edges.push_back({e[0] - first, e[1] - first});
  }
  alone.parts = {{part.name, 0, part.vertex_count, 0, part.triangle_count, 0, part.edge_count}};
  return alone;
}

std::vector<std::string> names_of(const io::Surface& surface) {
  std::vector<std::string> cloths;
  for (const io::SurfacePart& part : surface.parts) cloths.push_back(part.name);
  return cache_names(cloths);
}

/// Every cache stays open until the end.
void require_open_files(size_t count, const std::string& folder) {
  constexpr rlim_t others = 64;
  const rlim_t wanted = count + others;
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= wanted) return;
  limit.rlim_cur = std::min(limit.rlim_max, wanted);
  if (limit.rlim_cur == wanted && ::setrlimit(RLIMIT_NOFILE, &limit) == 0) return;
  throw io::OutputError(folder + ": the point caches of " + std::to_string(count) +
                        " cloths are as many open files (this system allows " +
                        std::to_string(limit.rlim_max) + ") write ply, or raise the limit");
}

/// Where floats are more than a tenth of a millimetre apart.
void warn_if_coarse(const io::Surface& start) {
  constexpr double fine_within = 1024;
  for (const io::SurfacePart& part : start.parts) {
    double most = 0;
    for (size_t i = 0; i < part.vertex_count; ++i) {
      const double3& p = start.positions[part.first_vertex + i];
      most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    if (most <= fine_within) continue;
    const float far = static_cast<float>(most);
    print_message("warning: cloth '" + part.name + "' is " + figure(most) +
                  " m from zero, where the floats of a point cache are " +
                  figure(double(std::nextafter(far, 3e38F) - far)) +
                  " m apart (its folds will be steps) write ply, or move the scene");
  }
}

class PointCaches final : public FrameSink {
 public:
  PointCaches(const std::string& folder, const io::Surface& start, Precision precision) {
    const std::vector<std::string> names = names_of(start);
    require_open_files(names.size(), folder);
    warn_if_coarse(start);
    for (size_t i = 0; i < names.size(); ++i) {
      const io::SurfacePart& part = start.parts[i];
      const auto path = std::filesystem::path(folder) / names[i];
      io::write_obj(path.string() + ".obj", part_of(start, part), fine_enough(start, precision));
      caches_.push_back(
          std::make_unique<io::PointCacheWriter>(path.string() + ".pc2", part.vertex_count));
    }
  }

  void add(const Frame& frame) override {
    for (size_t i = 0; i < caches_.size(); ++i) {
      caches_[i]->add(&frame.surface.positions[frame.surface.parts[i].first_vertex]);
    }
  }
  void commit() override {
    for (const auto& cache : caches_) cache->commit();
  }

 private:
  std::vector<std::unique_ptr<io::PointCacheWriter>> caches_;
};

}  // namespace

std::unique_ptr<FrameSink> make_obj_frames(const std::string& folder, MeshFormat format) {
  return std::make_unique<MeshFrames>(folder, "obj", io::write_obj, format);
}

std::unique_ptr<FrameSink> make_ply_frames(const std::string& folder, MeshFormat format) {
  return std::make_unique<MeshFrames>(folder, "ply", io::write_ply, format);
}

std::unique_ptr<FrameSink> make_point_caches(const std::string& folder, const io::Surface& start,
                                             Precision precision) {
  return std::make_unique<PointCaches>(folder, start, precision);
}

}  // namespace weft::tools
