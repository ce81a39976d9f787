#include "scene/winding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace weft::scene {

namespace {

struct Corner {
  double x, y, z;
  uint32_t place;
};

/// 1 where the edge goes up past the point on its right, -1 where it goes down past it, else 0.
int passes(const Corner& from, const Corner& to, const Point& p) {
  const bool below = from.y <= p.y, above = to.y > p.y;
  if (below != above) return 0;
  const bool ordered = from.place < to.place;
  const Corner &a = ordered ? from : to, &b = ordered ? to : from;
  const bool left = (b.y - a.y) * (p.z - a.z) - (b.z - a.z) * (p.y - a.y) >= 0;
  const bool is_left = left == ordered;  // of the edge in its own direction
  if (below) return is_left ? 1 : 0;
  return is_left ? 0 : -1;
}

/// Which way the ray from p goes through the triangle.
int crossing(const Corner (&c)[3], const Point& p) {
  const int turns = passes(c[0], c[1], p) + passes(c[1], c[2], p) + passes(c[2], c[0], p);
  if (turns == 0) return 0;
  const double ay = c[1].y - c[0].y, az = c[1].z - c[0].z, ax = c[1].x - c[0].x;
  const double by = c[2].y - c[0].y, bz = c[2].z - c[0].z, bx = c[2].x - c[0].x;
  const double nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
  if (nx == 0) return 0;
  const double x = c[0].x - ((p.y - c[0].y) * ny + (p.z - c[0].z) * nz) / nx;
  return x > p.x ? turns : 0;
}

}  // namespace

size_t Winding::cell(double at, double low, double size) const {
  if (!(size > 0)) return 0;
  const double k = std::floor((at - low) / size * double(cells_));
  return size_t(std::clamp(k, 0.0, double(cells_ - 1)));
}

void Winding::sort_into_cells() {
  double high_y = low_y_ = probes_[0].at.y, high_z = low_z_ = probes_[0].at.z;
  for (const Probe& p : probes_) {
    low_y_ = std::min(low_y_, p.at.y);
    low_z_ = std::min(low_z_, p.at.z);
    high_y = std::max(high_y, p.at.y);
    high_z = std::max(high_z, p.at.z);
  }
  size_y_ = high_y - low_y_;
  size_z_ = high_z - low_z_;
  while (cells_ < 1024 && (cells_ + 1) * (cells_ + 1) <= probes_.size()) ++cells_;
  const auto place = [&](const Probe& p) { return row(p.at.z) * cells_ + column(p.at.y); };
  start_.assign(cells_ * cells_ + 1, 0);
  for (const Probe& p : probes_) ++start_[place(p) + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  listed_.resize(probes_.size());
  Vector<uint32_t> next(start_.begin(), start_.end() - 1);
  for (uint32_t k = 0; k < probes_.size(); ++k) listed_[next[place(probes_[k])]++] = k;
}

void Winding::count(const Surface& surface, const Vector<uint32_t>& piece_of) {
  sort_into_cells();
  for (uint32_t t = 0; t < surface.triangles(); ++t) {
    Corner c[3];
    for (uint32_t k = 0; k < 3; ++k) {
      const double3& p = surface.positions[surface.vertex[3 * size_t(t) + k]];
      c[k] = {p.x, p.y, p.z, surface.place(3 * t + k)};
    }
    const auto [low_y, high_y] = std::minmax({c[0].y, c[1].y, c[2].y});
    const auto [low_z, high_z] = std::minmax({c[0].z, c[1].z, c[2].z});
    if (high_y < low_y_ || low_y > low_y_ + size_y_ || high_z < low_z_ ||
        low_z > low_z_ + size_z_) {
      continue;
    }
    for (size_t r = row(low_z); r <= row(high_z); ++r) {
      for (size_t k = r * cells_ + column(low_y); k <= r * cells_ + column(high_y); ++k) {
        for (uint32_t i = start_[k]; i < start_[k + 1]; ++i) {
          Probe& probe = probes_[listed_[i]];
          if (probe.piece != piece_of[t]) probe.turns += crossing(c, probe.at);
        }
      }
    }
  }
}

}  // namespace weft::scene
