#include "render/subdivide.h"

#include "render/box.h"

#include <algorithm>
#include <array>
#include <map>

namespace weft::render {
namespace {

constexpr size_t enough = 12500;  ///< triangles; a round makes four of one

/// One round: edges that are too long are halved, and each triangle is cut along the halves.
class Round {
 public:
  Round(const io::Mesh& mesh, double longest) : longest_(longest) {
    out_.positions = mesh.positions;
    for (size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) cut(&mesh.triangles[t]);
  }
  bool changed() const { return !middles_.empty(); }
  io::Mesh take() { return std::move(out_); }

 private:
  void cut(const uint32_t* v) {
    std::array<uint32_t, 3> middle{};
    size_t halved = 0, whole = 0;
    for (size_t k = 0; k < 3; ++k) {
      middle[k] = middle_of(v[k], v[(k + 1) % 3]);
      halved += middle[k] != none;
      if (middle[k] == none) whole = k;
    }
    if (halved == 0) return add(v[0], v[1], v[2]);
    if (halved == 3) {
      for (size_t k = 0; k < 3; ++k) add(v[k], middle[k], middle[(k + 2) % 3]);
      return add(middle[0], middle[1], middle[2]);
    }
    if (halved == 2) {  // from the whole edge a-b on: c is opposite
      const uint32_t a = v[whole], b = v[(whole + 1) % 3], c = v[(whole + 2) % 3];
      const uint32_t bc = middle[(whole + 1) % 3], ca = middle[(whole + 2) % 3];
      add(a, b, bc);
      add(a, bc, ca);
      return add(ca, bc, c);
    }
    for (size_t k = 0; k < 3; ++k) {
      if (middle[k] == none) continue;
      add(v[k], middle[k], v[(k + 2) % 3]);
      add(middle[k], v[(k + 1) % 3], v[(k + 2) % 3]);
    }
  }

  uint32_t middle_of(uint32_t a, uint32_t b) {
    const Vector3d p = vector(out_.positions[a]), q = vector(out_.positions[b]);
    if (!((p - q).norm() > longest_)) return none;
    const auto [middle, is_new] =
        middles_.emplace(std::minmax(a, b), uint32_t(out_.positions.size()));
    if (is_new) {
      const Vector3d m = 0.5 * (p + q);
      out_.positions.push_back({m.x(), m.y(), m.z()});
    }
    return middle->second;
  }
  void add(uint32_t a, uint32_t b, uint32_t c) {
    for (const uint32_t v : {a, b, c}) out_.triangles.push_back(v);
  }

  static constexpr uint32_t none = ~0u;
  double longest_;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles_;
  io::Mesh out_;
};

}  // namespace

io::Mesh subdivided(const io::Mesh& mesh, double longest) {
  io::Mesh fine = mesh;
  while (fine.triangles.size() <= 3 * enough) {
    Round round(fine, longest);
    if (!round.changed()) break;
    fine = round.take();
  }
  return fine;
}

// Rounds halve the edges until none is too long.
size_t most_pieces(const io::Mesh& mesh, double longest) {
  const size_t count = mesh.triangles.size() / 3;
  if (count > enough) return count;
  size_t sum = 0;
  for (size_t c = 0; c + 2 < mesh.triangles.size() && sum <= 4 * enough; c += 3) {
    double edge = 0;
    for (size_t k = 0; k < 3; ++k) {
      edge = std::max(edge, (vector(mesh.positions[mesh.triangles[c + k]]) -
                             vector(mesh.positions[mesh.triangles[c + (k + 1) % 3]]))
                                .norm());
    }
    size_t pieces = 1;
    for (; edge > longest && pieces <= 4 * enough; edge /= 2) pieces *= 4;
    sum += pieces;
  }
  return std::min(sum, 4 * enough);
}

}  // namespace weft::render
