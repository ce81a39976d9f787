#include "mesh_frames.h"

#include "io/point_cache.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace weft::tools {
namespace {

using Write = void (*)(const std::string&, const io::Surface&, Precision, bool);

class MeshFrames final : public FrameSink {
 public:
  MeshFrames(std::string folder, const char* extension, Write write, MeshFormat format)
      : folder_(std::move(folder)), extension_(extension), write_(write), format_(format) {}

  void add(const Frame& frame) override {
    write_(frame_path(folder_, frame.number, extension_), frame.surface, format_.precision,
           format_.normals);
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

class FileNames {
 public:
  std::string make(const std::string& cloth) {
    std::string name = cloth.substr(0, 200);  // a folder's entry has at most 255 bytes
    for (char& c : name) {
      const bool odd = static_cast<unsigned char>(c) < ' ' || c == '/' || c == '\\' || c == ':';
      if (odd) c = '_';
    }
    if (name[0] == '.') name[0] = '_';
    std::string free = name;
    for (int i = 2; !taken_.insert(free).second; ++i) free = name + "_" + std::to_string(i);
    return free;
  }

 private:
  std::set<std::string> taken_;
};

class PointCaches final : public FrameSink {
 public:
  PointCaches(const std::string& folder, const io::Surface& start, Precision precision) {
    FileNames names;
    for (const io::SurfacePart& part : start.parts) {
      const auto path = std::filesystem::path(folder) / names.make(part.name);
      io::write_obj(path.string() + ".obj", part_of(start, part), precision);
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
