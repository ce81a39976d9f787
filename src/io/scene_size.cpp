#include "io/scene_size.h"

#include "io/error.h"
#include "io/file_text.h"
#include "io/text_cursor.h"

#include <cmath>

namespace weft::io {
namespace {

constexpr uint64_t most_particles = uint64_t(1) << 30;
constexpr uint64_t per_particle = 250, per_triangle = 250, per_spring = 100;
constexpr uint64_t per_collider_triangle = 1200;

uint64_t particles(const Scene& scene) {
  uint64_t sum = 0;
  for (const ClothScene& cloth : scene.cloths) sum += vertex_count(cloth.shape);
  return sum;
}

uint64_t bytes_of(const Shape& shape) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    return mesh->mesh->triangles.size() / 3 * per_triangle;
  }
  if (const auto* network = std::get_if<NetworkShape>(&shape)) {
    return network->springs.size() * per_spring;
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

bool same_mesh(const MeshColliderScene& a, const MeshColliderScene& b) {
  return a.mesh == b.mesh && a.scale == b.scale && a.thickness == b.thickness &&
         a.closed == b.closed;
}

uint64_t bytes_to_build(const Scene& scene) {
  uint64_t sum = 0;
  for (const ClothScene& cloth : scene.cloths) sum += bytes_of(cloth.shape);
  std::vector<const MeshColliderScene*> meshes;
  for (const ColliderScene& collider : scene.colliders) {
    const auto* mesh = std::get_if<MeshColliderScene>(&collider);
    if (!mesh) continue;
    bool known = false;
    for (const MeshColliderScene* other : meshes) known = known || same_mesh(*mesh, *other);
    if (known) continue;
    meshes.push_back(mesh);
    sum += mesh->mesh->triangles.size() / 3 * per_collider_triangle;
  }
  return sum;
}

uint64_t bytes_to_run(const Scene& scene) {
  return bytes_to_build(scene) + particles(scene) * per_particle;
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

std::optional<std::string> beyond_memory(const Scene& scene) {
  return problem_of(bytes_to_run(scene), "run");
}

}  // namespace weft::io
