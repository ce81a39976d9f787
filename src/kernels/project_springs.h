// Springs as constraints: XPBD (Macklin, Mueller and Chentanez 2016, equation 18, one iteration a
// substep: Macklin et al. 2019, "Small Steps"), one colour at a time (state/coloured.h).
//
// A spring of stiffness k and rest length L between y_i and y_j of inverse masses w moves its ends
//
//     y_i += w_i s (y_j - y_i),  y_j -= w_j s (y_j - y_i),
//     s = (l - L)/(l (w_i + w_j + 1/(k h^2)))
//
// which is the implicit step of that spring alone. With damping b (N s/m) along the spring and u
// what l has gained in the substep, the force is k (l - L) + b u/h:
//
//     s = (k h^2 (l - L) + b h u)/(l ((k h^2 + b h)(w_i + w_j) + 1))
//
// y is never rounded: it is x_n, which stays, and the displacement d = y - x_n, which springs
// change. Both h^2 g and what a soft spring corrects are below the last bit of y from some 40
// substeps of 1/60 s on. Before: AdvanceParticles with Unsprung (forces without springs, the
// prediction, pins). Behind: with Projected, x_(n+1) = x_n + d.
#pragma once

#include "base/lanes.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// In place of the springs of a kind of cloth where they pull nothing: the prediction.
template <class TheFan>
struct Unsprung {
  using Fan = TheFan;
  static constexpr bool uneven = false;
  static constexpr bool projected = false;
  WEFT_HD int64_t work_before(int, int) const { return 0; }
  WEFT_HD bool stopped() const { return false; }

  template <class T, int N>
  WEFT_HD void gather(const ClothParams<T>&, const ParticleBuffers<T>&, int, int, Lanes<N> lanes,
                      LaneVec3<T, N>& force) const {
    lanes.each([&](int l) WEFT_LANE { force.set(l, {T(0), T(0), T(0)}); });
  }
};

/// And where they have been moved already.
struct NoFan {};
struct Projected : Unsprung<NoFan> {
  static constexpr bool projected = true;
};

/// A spring of no length, or between two pins, pulls nothing, whatever it is divided by.
template <class T>
WEFT_HD constexpr T least_weight() {
  return sizeof(T) == 4 ? T(1e-20) : T(1e-60);
}
/// 1/(k h^2), at most so much that a spring of no stiffness pulls nothing.
template <class T>
WEFT_HD T give_of(T stiffness, T square) {
  return T(1) / larger(stiffness * square, T(1e-30));
}

/// `give` = 1/(k h^2); weight = w_i + w_j.
template <class T>
struct Elastic {
  static constexpr bool damps = false;
  T give;
  WEFT_HD T scale(T length, T rest, T weight, T) const {
    return (length - rest) / (length * (weight + give) + least_weight<T>());
  }
};
/// Pulls only.
template <class T>
struct PullsOnly {
  static constexpr bool damps = false;
  T give;
  WEFT_HD T scale(T length, T rest, T weight, T) const {
    return larger(length - rest, T(0)) / (length * (weight + give) + least_weight<T>());
  }
};
/// `along`: l times what l has gained.
template <class T>
struct Damped {
  static constexpr bool damps = true;
  T pull, brake;  ///< k h^2, b h
  WEFT_HD T scale(T length, T rest, T weight, T along) const {
    const T gained = along / (length + least_weight<T>());
    return (pull * (length - rest) + brake * gained) /
           (length * ((pull + brake) * weight + T(1)) + least_weight<T>());
  }
};

template <class T>
struct ProjectSprings {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  T dt, square;
  int first_block;

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const SpringBlock& block = sim.coloured.block[first_block + index];
    const ClothParams<T>& cloth = sim.cloths[block.cloth];
    if (contains(every_stage, Stage::sleep) && sim.activity != nullptr &&
        sim.activity[block.cloth].asleep) {
      return;
    }
    const bool damps = contains(every_stage, Stage::spring_damping) && cloth.spring_damping > T(0);
    if (block.shift == 0) {
      if (damps) return project_listed<true>(block, cloth, lane0, lanes);
      return project_listed<false>(block, cloth, lane0, lanes);
    }
    const T k = cloth.stiffness[block.slot], rest = cloth.rest[block.slot];
    if (block.stride > 1) {
      const T stride = T(block.stride);
      return project_rarely(PullsOnly<T>{give_of(k / stride, square)}, stride * rest, block, lane0,
                            lanes);
    }
    if (damps) {
      const Damped<T> law{k * square, cloth.spring_damping * dt};
      return project_rarely(law, rest, block, lane0, lanes);
    }
    project(Elastic<T>{give_of(k, square)}, rest, block, lane0, lanes);
  }

 private:
  template <class Law, int N>
  WEFT_HD_COLD void project_rarely(const Law& law, T rest, const SpringBlock& block, int lane0,
                                   Lanes<N> lanes) const {
    project(law, rest, block, lane0, lanes);
  }

  /// Vectors as wide as there are springs: no lane may write what another spring's is.
  template <class Law, int N>
  WEFT_HD void project(const Law& law, T rest, const SpringBlock& block, int lane0,
                       Lanes<N> lanes) const {
    const int i0 = block.first, shift = block.shift, count = block.count;
    switch (block.step) {
      case 1:
        return strand<1>(law, rest, i0, shift, count, lane0, lanes);
      case 2:
        return strand<2>(law, rest, i0, shift, count, lane0, lanes);
      default:
        return strand<4>(law, rest, i0, shift, count, lane0, lanes);
    }
  }
  template <int Step, class Law>
  WEFT_HD void strand(const Law& law, T rest, int i0, int shift, int count, int lane0,
                      Lanes<1> lanes) const {
    if (lane0 < count) springs<Step>(law, rest, i0 + Step * lane0, shift, lanes);
  }
  template <int Step, class Law>
  WEFT_HD void strand(const Law& law, T rest, int i0, int shift, int count, int,
                      Lanes<block_size> lanes) const {
    if (count == block_size) return springs<Step>(law, rest, i0, shift, lanes);
    int done = 0;
    for (; done + 8 <= count; done += 8) {
      springs<Step>(law, rest, i0 + Step * done, shift, Lanes<8>{});
    }
    for (; done + 4 <= count; done += 4) {
      springs<Step>(law, rest, i0 + Step * done, shift, Lanes<4>{});
    }
    for (; done < count; ++done) springs<Step>(law, rest, i0 + Step * done, shift, Lanes<1>{});
  }

  template <int Step, class Law, int N>
  WEFT_HD void springs(const Law& law_of_all, T rest, int i0, int shift, Lanes<N> lanes) const {
    const Law law = law_of_all;
    const Vec3Array<T> x = p.x_in, d = p.d_out;
    const T* inverse_mass = sim.inverse_mass;
    lanes.each([=](int l) WEFT_LANE {
      const int i = i0 + Step * l;
      relax(law, x, d, inverse_mass, i, i + (Step == 2 ? 1 : Step == 4 ? 2 : shift), rest);
      if constexpr (Step == 4) relax(law, x, d, inverse_mass, i + 1, i + 3, rest);
    });
  }

  template <class Law>
  WEFT_HD static void relax(const Law& law, Vec3Array<T> x, Vec3Array<T> d, const T* inverse_mass,
                            int i, int j, T rest) {
    const Vec3<T> a = load(d, i), b = load(d, j), gained = b - a;
    const Vec3<T> to = (load(x, j) - load(x, i)) + gained;
    const T wa = inverse_mass[i], wb = inverse_mass[j];
    T along = T(0);
    if constexpr (Law::damps) along = dot(to, gained);
    const T s = law.scale(square_root(dot(to, to)), rest, wa + wb, along);
    store(d, i, a + (wa * s) * to);
    store(d, j, b - (wb * s) * to);
  }

  template <bool Damps, int N>
  WEFT_HD_COLD void project_listed(const SpringBlock& block, const ClothParams<T>& cloth, int lane0,
                                   Lanes<N> lanes) const {
    const Vec3Array<T> x = p.x_in, d = p.d_out;
    const T* inverse_mass = sim.inverse_mass;
    const int32_t *a = sim.coloured.a + block.first + lane0,
                  *b = sim.coloured.b + block.first + lane0;
    const T *rest = sim.coloured.rest + block.first + lane0,
            *stiffness = sim.coloured.stiffness + block.first + lane0;
    const T h2 = square, brake = cloth.spring_damping * dt;
    LaneVec3<T, N> of_a, of_b;
    lanes.each([&](int l) WEFT_LANE {
      const int i = a[l], j = b[l];
      const Vec3<T> d_a = load(d, i), d_b = load(d, j), gained = d_b - d_a;
      const Vec3<T> to = (load(x, j) - load(x, i)) + gained;
      const T wa = inverse_mass[i], wb = inverse_mass[j], length = square_root(dot(to, to));
      T s;
      if constexpr (Damps) {
        s = Damped<T>{stiffness[l] * h2, brake}.scale(length, rest[l], wa + wb, dot(to, gained));
      } else {
        s = Elastic<T>{give_of(stiffness[l], h2)}.scale(length, rest[l], wa + wb, T(0));
      }
      of_a.set(l, d_a + (wa * s) * to);
      of_b.set(l, d_b - (wb * s) * to);
    });
    for (int l = 0; l < N && lane0 + l < block.count; ++l) {
      store(d, a[l], of_a.get(l));
      store(d, b[l], of_b.get(l));
    }
  }
};

/// All colours of a cloth, one after the other, by one thread of a host: nobody waits, and a small
/// cloth stays in the cache.
template <class T>
struct ProjectCloths {
  ProjectSprings<T> springs;
  ColourTable table;

  static constexpr bool uneven = true;
  WEFT_HD int64_t work_before(int cloth) const { return table.work[cloth]; }

  template <int N>
  WEFT_HD void operator()(int cloth, int, Lanes<N> lanes) const {
    static_assert(N == block_size, "a host's kernel");
    const ColourSweep sweep = table.sweep[cloth];
    if (sweep.rows > 0) return sweep_rows(sweep, lanes);
    for (int colour = 0; colour < table.colours; ++colour) {
      const int32_t* start = table.of + colour * (table.cloths + 1) + cloth;
      for (int block = start[0]; block < start[1]; ++block) springs(block, 0, lanes);
    }
  }

 private:
  /// Rows are read once while they are in the cache. Any two springs that share a particle come in
  /// the order of their colours.
  template <int N>
  WEFT_HD void sweep_rows(const ColourSweep& sweep, Lanes<N> lanes) const {
    constexpr int together = 4;  // rows
    const int rows = sweep.rows, end = rows + sweep.lag[sweep.colours - 1];
    for (int row = 0; row < end; row += together) {
      for (int colour = 0; colour < sweep.colours; ++colour) {
        const int first = row - sweep.lag[colour], last = first + together;
        if (last <= 0 || first >= rows) continue;
        const int32_t* start = sweep.row_start + colour * (rows + 1);
        const int begin = start[first < 0 ? 0 : first], stop = start[last < rows ? last : rows];
        for (int block = begin; block < stop; ++block) springs(block, 0, lanes);
      }
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
