#include "bench/layouts.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "bench/layouts_kernel.h"

namespace weft::bench {

namespace {

/// What a candidate owns: components padded to whole blocks.
struct Owned {
  std::vector<float> x[3], next[3], d[3], force[3];
  std::vector<uint32_t> start;
  std::vector<int32_t> neighbour;
  std::vector<float> rest;
  int vertices = 0, width = 0;
  float stiffness = 100, a_factor = 0;

  explicit Owned(const std::vector<double3>& positions) {
    vertices = static_cast<int>((positions.size() + 31) / 32 * 32);
    for (int c = 0; c < 3; ++c) {
      x[c].assign(size_t(vertices), 0);
      for (size_t i = 0; i < positions.size(); ++i) {
        const double3 p = positions[i];
        x[c][i] = static_cast<float>(c == 0 ? p.x : c == 1 ? p.y : p.z);
      }
      next[c] = x[c];
      d[c].assign(size_t(vertices), 0);
      force[c].assign(size_t(vertices), 0);
    }
    // A step of 0.3 sqrt(m/k): positions stay where they are, which costs the same.
    a_factor = 0.09f / stiffness;
  }
  PlainSheet view() {
    PlainSheet s{};
    s.vertices = vertices;
    for (int c = 0; c < 3; ++c) {
      s.x[c] = x[c].data();
      s.next[c] = next[c].data();
      s.d[c] = d[c].data();
      s.force[c] = force[c].data();
    }
    s.stiffness = stiffness;
    s.a_factor = a_factor;
    return s;
  }
  PlainRows rows() const { return {start.data(), neighbour.data(), rest.data(), width}; }
  void swap() {
    for (int c = 0; c < 3; ++c) std::swap(x[c], next[c]);
  }
  float distance(uint32_t a, uint32_t b) const {
    float sum = 0;
    for (const auto& of : x) sum += (of[b] - of[a]) * (of[b] - of[a]);
    return std::sqrt(sum);
  }
};

std::vector<std::set<uint32_t>> neighbours_of(const TriangleSheet& sheet) {
  std::vector<std::set<uint32_t>> out(sheet.positions.size());
  for (size_t t = 0; t < sheet.triangles.size(); ++t) {
    const uint32_t a = sheet.triangles[t], b = sheet.triangles[t % 3 == 2 ? t - 2 : t + 1];
    out[a].insert(b);
    out[b].insert(a);
  }
  return out;
}

template <class Call>
void at_level(const char* isa, Call call) {
  if (std::strcmp(isa, "v4") == 0) return call(4);
  return call(std::strcmp(isa, "v3") == 0 ? 3 : 2);
}

size_t directed(const std::vector<std::set<uint32_t>>& neighbours) {
  size_t sum = 0;
  for (const auto& of : neighbours) sum += of.size();
  return sum;
}

}  // namespace

Candidate compressed_rows(const std::string& name, const TriangleSheet& sheet, const char* isa) {
  const auto neighbours = neighbours_of(sheet);
  auto owned = std::make_shared<Owned>(sheet.positions);
  owned->start.push_back(0);
  for (uint32_t v = 0; v < uint32_t(owned->vertices); ++v) {
    if (v < neighbours.size()) {
      for (const uint32_t n : neighbours[v]) {
        owned->neighbour.push_back(static_cast<int32_t>(n));
        owned->rest.push_back(owned->distance(v, n));
      }
    }
    owned->start.push_back(static_cast<uint32_t>(owned->neighbour.size()));
  }
  return {name, double(directed(neighbours)) / 2, [owned, isa] {
            at_level(isa, [&](int level) {
              const auto run = level == 4   ? layouts_v4::compressed
                               : level == 3 ? layouts_v3::compressed
                                            : layouts_v2::compressed;
              run(owned->view(), owned->rows());
            });
            owned->swap();
          }};
}

Candidate padded_rows(const std::string& name, const TriangleSheet& sheet, const char* isa) {
  const auto neighbours = neighbours_of(sheet);
  auto owned = std::make_shared<Owned>(sheet.positions);
  for (const auto& of : neighbours) owned->width = std::max(owned->width, int(of.size()));
  const auto vertices = static_cast<size_t>(owned->vertices);
  owned->neighbour.resize(size_t(owned->width) * vertices);
  owned->rest.resize(owned->neighbour.size());
  for (uint32_t v = 0; v < vertices; ++v) {
    size_t k = 0;
    if (v < neighbours.size()) {
      for (const uint32_t n : neighbours[v]) {
        owned->neighbour[k * vertices + v] = static_cast<int32_t>(n);
        owned->rest[k++ * vertices + v] = owned->distance(v, n);
      }
    }
    for (; k < size_t(owned->width); ++k) {
      owned->neighbour[k * vertices + v] = static_cast<int32_t>(v);
    }
  }
  return {name, double(directed(neighbours)) / 2, [owned, isa] {
            at_level(isa, [&](int level) {
              const auto run = level == 4   ? layouts_v4::padded
                               : level == 3 ? layouts_v3::padded
                                            : layouts_v2::padded;
              run(owned->view(), owned->rows());
            });
            owned->swap();
          }};
}

Candidate each_once(const std::string& name, uint32_t n, const char* isa) {
  const TriangleSheet sheet = triangle_sheet(n);
  auto owned = std::make_shared<Owned>(sheet.positions);
  for (const uint32_t other : {1u, n, n + 1}) owned->rest.push_back(owned->distance(0, other));
  const double springs = 2.0 * n * (n - 1) + double(n - 1) * (n - 1);
  return {name, springs, [owned, isa, n] {
            at_level(isa, [&](int level) {
              const auto run = level == 4   ? layouts_v4::once
                               : level == 3 ? layouts_v3::once
                                            : layouts_v2::once;
              PlainSheet view = owned->view();
              view.vertices = static_cast<int>(n * n);
              run(view, static_cast<int>(n), owned->rest.data());
            });
            owned->swap();
          }};
}

double padded_bytes(const TriangleSheet& sheet) {
  size_t width = 0;
  for (const auto& of : neighbours_of(sheet)) width = std::max(width, of.size());
  return double(width) * double(sheet.positions.size()) * (sizeof(int32_t) + sizeof(float));
}

}  // namespace weft::bench
