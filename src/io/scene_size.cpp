#include "io/scene_size.h"

#include "io/error.h"
#include "io/file_text.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace weft::io {
namespace {

constexpr uint64_t most_particles = uint64_t(1) << 30;
constexpr uint64_t per_particle = 250, per_triangle = 250, per_spring = 100;
constexpr uint64_t per_collider_triangle = 1200, per_collider_mesh = 50000;
/// Of positions, velocities and triangles that are read out to be written or drawn.
constexpr uint64_t per_particle_written = 300;

uint64_t particles(const Scene& scene) {
  uint64_t sum = 0;
  for (const ClothScene& cloth : scene.cloths) sum += vertex_count(cloth.shape);
  return sum;
}

uint64_t bytes_of(const Shape& shape) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    return mesh->mesh->triangles.size() / 3 * per_triangle + mesh->mesh->lines.size() * per_spring +
           vertex_count(shape) * per_particle;
  }
  if (const auto* network = std::get_if<NetworkShape>(&shape)) {
    return network->springs.size() * per_spring + vertex_count(shape) * per_particle;
  }
  return 0;  // a grid's springs are a rule
}

std::string gigabytes(uint64_t bytes) {
  return number_text(std::ceil(double(bytes) / 1e8) / 10) + " GB";
}

std::optional<std::string> problem_of(uint64_t bytes, const char* what) {
  if (bytes <= memory_size()) return std::nullopt;
  return "$: takes " + gigabytes(bytes) + " to " + what + " (this machine has " +
         gigabytes(memory_size()) + " of memory) give fewer particles or triangles";
}

}  // namespace

MeshKey key_of(const MeshColliderScene& d) {
  return {d.mesh.get(), d.scale, d.thickness, d.closed, d.weld_distance};
}

uint64_t bytes_to_build(const Scene& scene) {
  uint64_t sum = 0;
  for (const ClothScene& cloth : scene.cloths) sum += bytes_of(cloth.shape);
  std::set<MeshKey> known;
  for (const ColliderScene& collider : scene.colliders) {
    const auto* mesh = std::get_if<MeshColliderScene>(&collider);
    if (!mesh || !known.insert(key_of(*mesh)).second) continue;
    sum += mesh->mesh->triangles.size() / 3 * per_collider_triangle + per_collider_mesh;
  }
  return sum;
}

uint64_t bytes_to_run(const Scene& scene) {
  uint64_t sum = bytes_to_build(scene);
  for (const ClothScene& cloth : scene.cloths) {
    if (std::holds_alternative<GridShape>(cloth.shape)) {
      sum += vertex_count(cloth.shape) * per_particle;
    }
  }
  return sum;
}

uint64_t bytes_to_run(const Scene& scene, uint64_t planned) {
  return std::max(bytes_to_run(scene), planned + particles(scene) * per_particle_written);
}

void require_buildable(const Scene& scene) {
  if (particles(scene) > most_particles) {
    throw InputError(scene.file + ": $.cloths: a scene of " + std::to_string(particles(scene)) +
                     " particles (it holds at most 2^30) give fewer");
  }
  if (const auto problem = problem_of(bytes_to_build(scene), "build")) {
    throw InputError(scene.file + ": " + *problem);
  }
}

std::optional<std::string> beyond_memory(uint64_t bytes) { return problem_of(bytes, "run"); }

}  // namespace weft::io
