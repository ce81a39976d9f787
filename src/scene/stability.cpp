#include "scene/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/grid.h"

namespace weft::scene {

namespace {

class BoundSearch {
 public:
  BoundSearch(const CookedFabric& fabric, const BoundInput& input)
      : fabric_(fabric), input_(input) {}

  Bound find() {
    if (fabric_.is_grid) {
      over_grid();
    } else {
      over_rows();
    }
    const double root_k = input_.springs ? std::sqrt(stiffness_) : 0;
    const double c = damping_.value + drag_.value;
    if (root_k == 0 && c == 0) return {std::numeric_limits<double>::infinity(), 0, 0};
    // The root of dt^2 K + 2 dt C = 4 without cancellation or overflow.
    const double dt = with_wind(4 / (c + std::hypot(c, 2 * root_k)), root_k * root_k, c);
    // Named is what alone would bound the step most.
    if (root_k >= c) return {dt, a_, b_};
    const Worst& worst = damping_.value >= drag_.value ? damping_ : drag_;
    return {dt, worst.a, worst.b};
  }

 private:
  /// dt^2 K + 2 dt C + 2 G/(1 + G) = 4, G = dt w, below the root without wind.
  double with_wind(double dt, double k, double c) const {
    const double w = input_.wind > 0 ? input_.wind * largest_area_by_mass() : 0;
    if (!(w > 0)) return dt;
    double low = dt / 2, high = dt;
    for (int round = 0; round < 60; ++round) {
      const double t = (low + high) / 2;
      (t * t * k + 2 * t * c + 2 * t * w / (1 + t * w) > 4 ? high : low) = t;
    }
    return low;
  }

  /// The largest sum of 2 A by the mass of a vertex, 1/kg m^2.
  double largest_area_by_mass() const {
    Vector<double> sum(fabric_.vertices, 0);
    uint32_t v[3];
    for (uint64_t t = 0; t < triangle_count(fabric_); ++t) {
      triangle(fabric_, t, v);
      const double3 a = fabric_.position_of(v[0]), b = fabric_.position_of(v[1]),
                    c = fabric_.position_of(v[2]);
      const double3 p{b.x - a.x, b.y - a.y, b.z - a.z}, q{c.x - a.x, c.y - a.y, c.z - a.z};
      const double x = p.y * q.z - p.z * q.y, y = p.z * q.x - p.x * q.z, z = p.x * q.y - p.y * q.x;
      for (const uint32_t corner : v) sum[corner] += std::sqrt(x * x + y * y + z * z);
    }
    double most = 0;
    for (uint32_t i = 0; i < fabric_.vertices; ++i) {
      most = std::max(most, sum[i] * inverse_mass(i));
    }
    return most;
  }

  double inverse_mass(uint32_t v) const {
    return input_.pinned && (*input_.pinned)[v] ? 0 : 1 / fabric_.mass_of(v);
  }

  /// One spring with the summed stiffness and the valence of its ends.
  void spring(uint32_t a, uint32_t b, double sum_a, double sum_b, double valence_a,
              double valence_b) {
    const double wa = inverse_mass(a), wb = inverse_mass(b);
    const double k = sum_a * wa + sum_b * wb;
    if (k > stiffness_) {
      stiffness_ = k;
      a_ = a;
      b_ = b;
    }
    const double c = input_.spring_damping * (valence_a * wa + valence_b * wb);
    if (c > damping_.value) damping_ = {c, a, b};
  }

  void vertex(uint32_t v) {
    const double c = input_.lagged_drag * inverse_mass(v);
    if (c > drag_.value) drag_ = {c, v, v};
  }

  struct Worst {
    double value = 0;
    uint32_t a = 0, b = 0;
  };
  struct Sum {
    double stiffness = 0, valence = 0;
  };

  Sum grid_sum(int64_t row, int64_t column) const {
    const StencilTable& table = stencil_table(fabric_.grid.stencil);
    Sum sum;
    for (int k = 0; k < table.count; ++k) {
      if (!has_neighbour(fabric_.grid, row, column, table.offset[k])) continue;
      sum.stiffness += stencil_stiffness(table.offset[k], fabric_.stiffness);
      sum.valence += 1;
    }
    return sum;
  }

  /// Sums depend on the distance to the border only, up to twice its stencil radius.
  Vector<uint32_t> representatives(uint32_t count) const {
    Vector<uint32_t> all;
    const bool every = input_.pinned != nullptr || !fabric_.masses.empty() || count <= 16;
    for (uint32_t i = 0; i < count; ++i) {
      if (every || i < 8 || i >= count - 8) all.push_back(i);
    }
    return all;
  }

  void over_grid() {
    const CookedGrid& g = fabric_.grid;
    const StencilTable& table = stencil_table(g.stencil);
    // Sums by class of row and column: distance to the near border, to the far border, or inside.
    const auto class_of = [](uint32_t i, uint32_t count) {
      return count <= 9 ? i : i < 4 ? i : i + 4 >= count ? 8 - (count - 1 - i) : 4;
    };
    const auto member = [](uint32_t c, uint32_t count) {
      return count <= 9 ? c : c <= 4 ? c : count - 1 - (8 - c);
    };
    Sum sums[9][9];
    for (uint32_t r = 0; r < std::min(g.rows, 9u); ++r) {
      for (uint32_t c = 0; c < std::min(g.columns, 9u); ++c) {
        sums[r][c] = grid_sum(member(r, g.rows), member(c, g.columns));
      }
    }
    for (const uint32_t row : representatives(g.rows)) {
      for (const uint32_t column : representatives(g.columns)) {
        const uint32_t a = row * g.columns + column;
        vertex(a);
        const Sum& here = sums[class_of(row, g.rows)][class_of(column, g.columns)];
        for (int k = table.count / 2; k < table.count; ++k) {
          const StencilOffset o = table.offset[k];
          if (!has_neighbour(g, row, column, o)) continue;
          const auto r = static_cast<uint32_t>(int64_t(row) + o.row);
          const auto c = static_cast<uint32_t>(int64_t(column) + o.column);
          const Sum& there = sums[class_of(r, g.rows)][class_of(c, g.columns)];
          spring(a, r * g.columns + c, here.stiffness, there.stiffness, here.valence,
                 there.valence);
        }
      }
    }
  }

  double row_sum(uint32_t v) const {
    const SpringRows& rows = fabric_.rows;
    const uint64_t first = rows.start[v], end = rows.start[size_t(v) + 1];
    if (rows.stiffness.empty()) return double(end - first) * fabric_.stiffness.stretch;
    double sum = 0;
    for (uint64_t e = first; e < end; ++e) sum += rows.stiffness[e];
    return sum;
  }

  void over_rows() {
    const SpringRows& rows = fabric_.rows;
    Vector<double> sums(fabric_.vertices);
    for (uint32_t v = 0; v < fabric_.vertices; ++v) sums[v] = row_sum(v);
    const auto valence = [&](uint32_t v) {
      return double(rows.start[size_t(v) + 1] - rows.start[v]);
    };
    for (uint32_t v = 0; v < fabric_.vertices; ++v) {
      vertex(v);
      for (uint64_t e = rows.start[v]; e < rows.start[size_t(v) + 1]; ++e) {
        const uint32_t n = rows.neighbour[e];
        if (n > v) spring(v, n, sums[v], sums[n], valence(v), valence(n));
      }
    }
  }

  const CookedFabric& fabric_;
  const BoundInput& input_;
  double stiffness_ = 0;
  Worst damping_, drag_;
  uint32_t a_ = 0, b_ = 0;
};

}  // namespace

Bound stable_bound(const CookedFabric& fabric, const BoundInput& input) {
  return BoundSearch(fabric, input).find();
}

}  // namespace weft::scene
