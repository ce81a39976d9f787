// Pieces of collider meshes: how many, how long, and of the same surface.
#include "render/subdivide.h"

#include "render/box.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

using namespace weft;
using namespace weft::render;

namespace {

/// Triangles with corners anywhere in a cube of 2 m.
io::Mesh soup(uint32_t count, double flat) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-1, 1);
  io::Mesh mesh;
  for (uint32_t i = 0; i < 3 * count; ++i) {
    const double x = at(random), y = at(random), z = flat * at(random);
    mesh.positions.push_back({x, y, z});
    mesh.triangles.push_back(i);
  }
  return mesh;
}

double area(const io::Mesh& mesh) {
  double sum = 0;
  for (size_t c = 0; c + 2 < mesh.triangles.size(); c += 3) {
    const Vector3d a = vector(mesh.positions[mesh.triangles[c]]);
    const Vector3d ab = vector(mesh.positions[mesh.triangles[c + 1]]) - a;
    const Vector3d ac = vector(mesh.positions[mesh.triangles[c + 2]]) - a;
    sum += 0.5 * ab.cross(ac).norm();
  }
  return sum;
}

double longest_edge(const io::Mesh& mesh) {
  double longest = 0;
  for (size_t c = 0; c < mesh.triangles.size(); ++c) {
    const size_t next = c % 3 == 2 ? c - 2 : c + 1;
    longest = std::max(longest, (vector(mesh.positions[mesh.triangles[c]]) -
                                 vector(mesh.positions[mesh.triangles[next]]))
                                    .norm());
  }
  return longest;
}

}  // namespace

TEST(Subdivided, IsTheSameSurfaceInShortPieces) {
  for (const double longest : {3.0, 0.7, 0.2}) {
    const io::Mesh mesh = soup(20, 1), fine = subdivided(mesh, longest);
    EXPECT_LE(longest_edge(fine), longest);
    EXPECT_NEAR(area(fine), area(mesh), 1e-12 * area(mesh));
  }
}

TEST(Subdivided, HasNoMorePiecesThanIsSaidBefore) {
  for (const uint32_t count : {1u, 20u, 3000u, 12500u, 12501u, 30000u}) {
    for (const double flat : {1.0, 0.01}) {
      const io::Mesh mesh = soup(count, flat);
      for (const double longest : {3.0, 1.5, 0.4, 0.1, 0.01, 1e-6}) {
        const size_t pieces = subdivided(mesh, longest).triangles.size() / 3;
        EXPECT_LE(pieces, most_pieces(mesh, longest)) << count << " " << longest;
        EXPECT_LE(pieces, std::max<size_t>(count, 50000));
      }
    }
  }
}
