#include "lengthening.h"

#include <algorithm>
#include <cmath>

namespace weft::tools {

static double distance(double3 a, double3 b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

std::vector<double3> Lengthening::read(io::RunningScene& made, size_t cloth) const {
  std::vector<double3> x(made.fabrics[cloth].vertex_count());
  made.require(made.world.read_positions(made.cloths[cloth], x.data()), scene_.file);
  return x;
}

/// take(a, b, rest): particles, and a rest length below 0 where it is initial.
template <class Take>
void Lengthening::each_spring(const io::RunningScene& made, size_t cloth, Take take) const {
  constexpr uint64_t chunk = 4096;
  const Fabric& fabric = made.fabrics[cloth];
  const io::ClothScene& scene = scene_.cloths[cloth];
  uint32_t corner[3 * chunk];
  for (uint64_t first = 0; first < fabric.triangle_count(); first += chunk) {
    const uint64_t count = std::min(chunk, fabric.triangle_count() - first);
    made.require(fabric.read_triangles(first, count, corner), scene_.file);
    for (uint64_t k = 0; k < 3 * count; ++k) {
      take(corner[k], corner[k % 3 == 2 ? k - 2 : k + 1], scene.rest_length);
    }
  }
  if (std::holds_alternative<io::GridShape>(scene.shape) && fabric.triangle_count() == 0) {
    for (uint32_t v = 1; v < fabric.vertex_count(); ++v) take(v - 1, v, scene.rest_length);
  }
  const auto* lines = io::lines_of(scene.shape);
  const std::vector<uint32_t>& particles = made.particles[cloth];
  for (const Spring& s : lines ? *lines : std::vector<Spring>{}) {
    take(particles.empty() ? s.a : particles[s.a], particles.empty() ? s.b : particles[s.b],
         s.rest_length >= 0 ? s.rest_length : scene.rest_length);
  }
}

Lengthening::Lengthening(const io::Scene& scene, io::RunningScene& made) : scene_(scene) {
  for (size_t i = 0; i < made.cloths.size(); ++i) start_.push_back(read(made, i));
}

double Lengthening::most(io::RunningScene& made) const {
  double most = 0;
  for (size_t i = 0; i < made.cloths.size(); ++i) {
    const std::vector<double3>& start = start_[i];
    const std::vector<double3> now = read(made, i);
    const auto rest_of = [&](uint32_t a, uint32_t b, double rest) {
      return rest >= 0 ? rest : distance(start[a], start[b]);
    };
    double sum = 0, count = 0;
    each_spring(made, i, [&](uint32_t a, uint32_t b, double rest) {
      sum += rest_of(a, b, rest);
      count += 1;
    });
    if (!(sum > 0)) continue;
    each_spring(made, i, [&](uint32_t a, uint32_t b, double rest) {
      const double l0 = rest_of(a, b, rest);
      most = std::max(most, (distance(now[a], now[b]) - l0) / std::max(l0, sum / count));
    });
  }
  return most;
}

}  // namespace weft::tools
