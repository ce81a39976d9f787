#include "io/polygon.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace weft::io {
namespace {

constexpr uint64_t work_per_corner = 500, free_work = 1000000;
/// In parts of the polygon's size: doubles, and corners that were written as one place.
constexpr double tiny = 1e-12, one_place = 1e-9;

double3 minus(double3 a, double3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double3 times(double s, double3 a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(double3 a, double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double3 cross(double3 a, double3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double largest(double3 a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }

/// Perpendicular to a unit vector; along an axis where that is.
double3 perpendicular(double3 n) {
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  const double3 axis = x <= y && x <= z ? double3{1, 0, 0}
                       : y <= z         ? double3{0, 1, 0}
                                        : double3{0, 0, 1};
  const double3 u = cross(axis, n);
  return times(1 / std::sqrt(dot(u, u)), u);
}

bool is_longer(double a, double b, uint32_t tip_a, uint32_t tip_b) {
  return a != b ? a > b : tip_a > tip_b;
}

}  // namespace

bool append_fan(const Polygon& polygon, std::vector<uint32_t>& triangles, MemoryLimit& memory) {
  if (!memory.make_room(triangles, 3 * (polygon.size() - 2))) return false;
  for (size_t k = 2; k < polygon.size(); ++k) {
    triangles.insert(triangles.end(), {polygon[0], polygon[k - 1], polygon[k]});
  }
  return true;
}

void read_fan(const uint32_t* fan, size_t corners, Polygon& polygon) {
  polygon.assign({fan[0], fan[1]});
  for (size_t k = 2; k < corners; ++k) polygon.push_back(fan[3 * (k - 2) + 2]);
}

const uint32_t* repeated_vertex(Polygon& scratch) {
  if (scratch.size() <= 3) return nullptr;
  std::sort(scratch.begin(), scratch.end());
  const auto twice = std::adjacent_find(scratch.begin(), scratch.end());
  return twice == scratch.end() ? nullptr : &*twice;
}

std::string to_text(Cut cut, size_t corners) {
  switch (cut) {
    case Cut::no_area:
      return "has no area (its corners lie on one line, or what it goes round cancels) correct or "
             "remove it";
    case Cut::crossing:
      return "crosses itself (its triangles would overlap) list its corners along the outline, or "
             "give triangles";
    case Cut::too_long:
      return "has " + std::to_string(corners) +
             " corners in a shape that takes too long to cut (more than " +
             std::to_string(work_per_corner) + " comparisons for each) give triangles";
    default:
      return "";
  }
}

Cut PolygonCutter::cut(const std::vector<double3>& positions, const Polygon& polygon,
                       uint32_t* out) {
  const size_t corners = polygon.size();
  if (corners == 3) {
    std::copy(polygon.begin(), polygon.end(), out);
    return Cut::done;
  }
  if (!make_room(corners)) return Cut::no_memory;
  work_ = 0;
  most_work_ = free_work + work_per_corner * corners;
  if (!flatten(positions, polygon)) return Cut::no_area;
  if (is_fan()) {
    for (size_t k = 2; k < corners; ++k, out += 3) {
      out[0] = ring_[0];
      out[1] = ring_[k - 1];
      out[2] = ring_[k];
    }
    return Cut::done;
  }
  if (crosses()) return work_ > most_work_ ? Cut::too_long : Cut::crossing;
  return clip(out);
}

bool PolygonCutter::make_room(size_t corners) {
  const auto room = [&](auto& array, size_t count) {
    array.clear();
    return memory_.make_room(array, count);
  };
  return room(ring_, corners) && room(space_, corners) && room(flat_, corners) &&
         room(before_, corners) && room(after_, corners) && room(order_, 3 * corners) &&
         room(cell_start_, corners + 2) && room(cell_corner_, corners) && room(ears_, 3 * corners);
}

/// False when the polygon has no area.
bool PolygonCutter::flatten(const std::vector<double3>& positions, const Polygon& polygon) {
  const auto lowest = std::min_element(polygon.begin(), polygon.end());
  ring_.assign(lowest, polygon.end());
  ring_.insert(ring_.end(), polygon.begin(), lowest);

  double far = 0;
  for (const uint32_t v : ring_) far = std::max(far, largest(positions[v]));
  const double safe = far > 0x1p500 ? 0x1p-524 : far < 0x1p-500 ? 0x1p500 : 1;  // exact
  const double3 origin = times(safe, positions[ring_[0]]);
  double size = 0;
  for (const uint32_t v : ring_) {
    space_.push_back(minus(times(safe, positions[v]), origin));
    size = std::max(size, largest(space_.back()));
  }
  if (!(size > 0)) return false;
  for (double3& p : space_) p = {p.x / size, p.y / size, p.z / size};
  rounding_ = std::min(1e-4, 0x1p-22 * std::max(1.0, far * safe / size));

  double3 area{0, 0, 0};  // twice (Newell)
  for (size_t i = 1; i + 1 < space_.size(); ++i) {
    const double3 part = cross(space_[i], space_[i + 1]);
    area = {area.x + part.x, area.y + part.y, area.z + part.z};
  }
  const double twice = std::sqrt(dot(area, area));
  if (!(twice > 1e-10)) return false;
  const double3 n = times(1 / twice, area), u = perpendicular(n), v = cross(n, u);
  double above = 0, below = 0;
  for (const double3& p : space_) {
    flat_.push_back({dot(u, p), dot(v, p)});
    above = std::max(above, dot(n, p));
    below = std::min(below, dot(n, p));
  }
  planar_ = above - below <= std::max(1e-5, rounding_);
  return true;
}

double PolygonCutter::turn(uint32_t a, uint32_t b, uint32_t c) const {
  const Flat &p = flat_[a], &q = flat_[b], &r = flat_[c];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Of the triangle above its longest side; negative when it runs clockwise.
double PolygonCutter::height(uint32_t a, uint32_t b, uint32_t c) const {
  const auto square = [&](uint32_t i, uint32_t j) {
    const double x = flat_[i].x - flat_[j].x, y = flat_[i].y - flat_[j].y;
    return x * x + y * y;
  };
  const double longest = std::max({square(a, b), square(b, c), square(c, a)});
  return longest > 0 ? turn(a, b, c) / std::sqrt(longest) : 0;
}

/// Flat, convex, and nowhere a triangle without area.
bool PolygonCutter::is_fan() const {
  if (!planar_) return false;
  const auto n = static_cast<uint32_t>(ring_.size());
  for (uint32_t i = 0; i < n; ++i) {
    if (!(height(i, (i + 1) % n, (i + 2) % n) > rounding_)) return false;
  }
  for (uint32_t k = 2; k < n; ++k) {
    if (!(height(0, k - 1, k) > rounding_) || !(turn(0, 1, k) > 0)) return false;
  }
  return true;
}

/// True, too, when there is too much to compare. Sides are swept along the axis on which they are
/// shorter.
bool PolygonCutter::crosses() {
  const auto n = static_cast<uint32_t>(ring_.size());
  double x = 0, y = 0;
  for (uint32_t i = 0; i < n; ++i) {
    x += std::fabs(flat_[i].x - flat_[(i + 1) % n].x);
    y += std::fabs(flat_[i].y - flat_[(i + 1) % n].y);
  }
  const bool along_x = x <= y;
  const auto place = [&](uint32_t i) { return along_x ? flat_[i % n].x : flat_[i % n].y; };
  const auto low = [&](uint32_t i) { return std::min(place(i), place(i + 1)); };
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0u);
  std::sort(order_.begin(), order_.end(),
            [&](uint32_t i, uint32_t j) { return low(i) != low(j) ? low(i) < low(j) : i < j; });
  for (uint32_t a = 0; a < n; ++a) {
    const uint32_t i = order_[a];
    const double high = std::max(place(i), place(i + 1));
    for (uint32_t b = a + 1; b < n && low(order_[b]) <= high; ++b) {
      if (++work_ > most_work_ || crosses(i, order_[b])) return true;
    }
  }
  return false;
}

/// Sides i and j, from corners i and j on, go through each other.
bool PolygonCutter::crosses(uint32_t i, uint32_t j) const {
  const auto n = static_cast<uint32_t>(ring_.size());
  const uint32_t i1 = (i + 1) % n, j1 = (j + 1) % n;
  if (i1 == j || j1 == i) return false;
  const auto parted = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    const double x = flat_[b].x - flat_[a].x, y = flat_[b].y - flat_[a].y;
    const double hair = rounding_ * std::sqrt(x * x + y * y);
    const double first = turn(a, b, c), second = turn(a, b, d);
    return (first > hair && second < -hair) || (first < -hair && second > hair);
  };
  return parted(i, i1, j, j1) && parted(j, j1, i, i1);
}

Cut PolygonCutter::clip(uint32_t* out) {
  const auto n = static_cast<uint32_t>(ring_.size());
  left_ = n;
  before_.resize(n);
  after_.resize(n);
  for (uint32_t i = 0; i < n; ++i) {
    before_[i] = i == 0 ? n - 1 : i - 1;
    after_[i] = i + 1 == n ? 0 : i + 1;
  }
  order_.clear();  // the triangles, until all are known
  order_.resize(3 * (size_t(n) - 2));
  uint32_t* next = order_.data();
  const Rules rules[] = {{rounding_, rounding_}, {tiny, tiny}, {tiny, -tiny}};
  while (left_ > 3) {
    const bool clipped = std::any_of(std::begin(rules), std::end(rules),
                                     [&](Rules r) { return clip_ears(r, next); });
    if (work_ > most_work_) return Cut::too_long;
    if (!clipped && !clip_flat(next)) return Cut::crossing;
  }
  uint32_t first = 0;
  while (is_cut(first)) ++first;
  if (height(before_[first], first, after_[first]) < -rounding_) return Cut::crossing;
  remove(first, next);
  for (size_t k = 0; k < order_.size(); ++k) out[k] = ring_[order_[k]];
  return Cut::done;
}

size_t PolygonCutter::cell(double place) const {
  const double at = std::floor((place + 2) * 0.25 * double(cells_));
  return size_t(std::clamp(at, 0.0, double(cells_ - 1)));
}

/// The corners by the cells of a grid over the plane.
void PolygonCutter::list_corners() {
  cells_ = 1;
  while (cells_ < 1024 && (cells_ + 1) * (cells_ + 1) <= left_) ++cells_;
  cell_start_.assign(cells_ * cells_ + 1, 0);
  const auto cell_of = [&](uint32_t i) { return cell(flat_[i].y) * cells_ + cell(flat_[i].x); };
  for (uint32_t i = 0; i < ring_.size(); ++i) {
    if (!is_cut(i)) ++cell_start_[cell_of(i) + 1];
  }
  std::partial_sum(cell_start_.begin(), cell_start_.end(), cell_start_.begin());
  cell_corner_.resize(left_);
  for (auto i = static_cast<uint32_t>(ring_.size()); i-- > 0;) {
    if (!is_cut(i)) cell_corner_[--cell_start_[cell_of(i) + 1]] = i;
  }
  // Filled from the back, each start now stands where the cell before it began.
  for (size_t k = 0; k + 1 < cell_start_.size(); ++k) cell_start_[k] = cell_start_[k + 1];
  cell_start_.back() = static_cast<uint32_t>(left_);
  work_ += ring_.size();
}

void PolygonCutter::offer(uint32_t tip, Rules rules) {
  const uint32_t a = before_[tip], c = after_[tip];
  if (!(height(a, tip, c) > rules.flat)) return;
  const double3 diagonal = minus(space_[a], space_[c]);
  if (ears_.size() == ears_.capacity()) return;  // found again in the next round
  ears_.push_back({dot(diagonal, diagonal), tip, a, c});
  std::push_heap(ears_.begin(), ears_.end(), [](const Ear& x, const Ear& y) {
    return is_longer(x.diagonal, y.diagonal, x.tip, y.tip);
  });
}

bool PolygonCutter::is_blocked(const Ear& ear, Rules rules) {
  const uint32_t corner[] = {ear.before, ear.tip, ear.after};
  double hair[3];
  for (int k = 0; k < 3; ++k) {
    const Flat &p = flat_[corner[k]], &q = flat_[corner[(k + 1) % 3]];
    const double x = q.x - p.x, y = q.y - p.y;
    hair[k] = rules.outside * std::sqrt(x * x + y * y);
  }
  const auto at_a_corner = [&](uint32_t q) {
    return std::any_of(std::begin(corner), std::end(corner), [&](uint32_t c) {
      return std::fabs(flat_[c].x - flat_[q].x) <= one_place &&
             std::fabs(flat_[c].y - flat_[q].y) <= one_place;
    });
  };
  const auto [left, right] =
      std::minmax({flat_[corner[0]].x, flat_[corner[1]].x, flat_[corner[2]].x});
  const auto [low, high] =
      std::minmax({flat_[corner[0]].y, flat_[corner[1]].y, flat_[corner[2]].y});
  const double wide = std::max(rules.outside, 0.0);
  for (size_t row = cell(low - wide); row <= cell(high + wide); ++row) {
    for (size_t column = cell(left - wide); column <= cell(right + wide); ++column) {
      const size_t at = row * cells_ + column;
      ++work_;
      for (uint32_t k = cell_start_[at]; k < cell_start_[at + 1]; ++k) {
        const uint32_t q = cell_corner_[k];
        ++work_;
        if (is_cut(q) || turn(corner[0], corner[1], q) < -hair[0] ||
            turn(corner[1], corner[2], q) < -hair[1] || turn(corner[2], corner[0], q) < -hair[2]) {
          continue;
        }
        if (!at_a_corner(q)) return true;
      }
    }
  }
  return false;
}

void PolygonCutter::remove(uint32_t tip, uint32_t*& out) {
  const uint32_t a = before_[tip], c = after_[tip];
  out[0] = a;
  out[1] = tip;
  out[2] = c;
  out += 3;
  after_[a] = c;
  before_[c] = a;
  after_[tip] = before_[tip] = tip;
  --left_;
}

/// True when it clipped one.
bool PolygonCutter::clip_ears(Rules rules, uint32_t*& out) {
  const size_t begin = left_;
  ears_.clear();
  list_corners();
  for (uint32_t i = 0; i < ring_.size(); ++i) {
    if (!is_cut(i)) offer(i, rules);
  }
  while (left_ > 3 && !ears_.empty() && work_ <= most_work_) {
    std::pop_heap(ears_.begin(), ears_.end(), [](const Ear& x, const Ear& y) {
      return is_longer(x.diagonal, y.diagonal, x.tip, y.tip);
    });
    const Ear ear = ears_.back();
    ears_.pop_back();
    const bool stale =
        after_[ear.tip] != ear.after || before_[ear.tip] != ear.before || ear.tip == ear.after;
    if (stale || is_blocked(ear, rules)) continue;
    remove(ear.tip, out);
    offer(ear.before, rules);
    offer(ear.after, rules);
  }
  return left_ < begin;
}

/// Corners that lie between or on their neighbours: what is left where an outline touches itself.
bool PolygonCutter::clip_flat(uint32_t*& out) {
  const size_t begin = left_;
  work_ += ring_.size();
  for (uint32_t i = 0; i < ring_.size() && left_ > 3; ++i) {
    if (is_cut(i) || std::fabs(height(before_[i], i, after_[i])) > tiny) continue;
    remove(i, out);
  }
  return left_ < begin;
}

}  // namespace weft::io
