#include "bench/layouts_kernel.h"

#include <cmath>

namespace weft::bench::WEFT_LAYOUTS_NS {

namespace {

inline float tension_of(float x, float y, float z, float stiffness, float rest) {
  const float length = std::sqrt(x * x + y * y + z * z);
  return length > 0 ? stiffness * (length - rest) / length : 0.0f;
}

void integrate(const PlainSheet& s, int i, float fx, float fy, float fz) {
  const float f[3] = {fx, fy, fz};
  for (int c = 0; c < 3; ++c) {
    s.d[c][i] += s.a_factor * f[c];
    s.next[c][i] = s.x[c][i] + s.d[c][i];
  }
}

constexpr int block = 32;

}  // namespace

void compressed(const PlainSheet& shared, const PlainRows& rows) {
  const PlainSheet s = shared;
  for (int i = 0; i < s.vertices; ++i) {
    float fx = 0, fy = 0, fz = 0;
    for (uint32_t e = rows.start[i]; e < rows.start[i + 1]; ++e) {
      const int j = rows.neighbour[e];
      const float x = s.x[0][j] - s.x[0][i], y = s.x[1][j] - s.x[1][i], z = s.x[2][j] - s.x[2][i];
      const float t = tension_of(x, y, z, s.stiffness, rows.rest[e]);
      fx += t * x;
      fy += t * y;
      fz += t * z;
    }
    integrate(s, i, fx, fy, fz);
  }
}

void padded(const PlainSheet& shared, const PlainRows& rows) {
  const PlainSheet s = shared;
  for (int first = 0; first < s.vertices; first += block) {
    float f[3][block] = {};
    for (int k = 0; k < rows.width; ++k) {
      const int32_t* neighbour = rows.neighbour + size_t(k) * size_t(s.vertices) + first;
      const float* rest = rows.rest + size_t(k) * size_t(s.vertices) + first;
#pragma omp simd
      for (int l = 0; l < block; ++l) {
        const int j = neighbour[l], i = first + l;
        const float x = s.x[0][j] - s.x[0][i], y = s.x[1][j] - s.x[1][i], z = s.x[2][j] - s.x[2][i];
        const float t = tension_of(x, y, z, s.stiffness, rest[l]);
        f[0][l] += t * x;
        f[1][l] += t * y;
        f[2][l] += t * z;
      }
    }
    for (int c = 0; c < 3; ++c) {
#pragma omp simd
      for (int l = 0; l < block; ++l) {
        s.d[c][first + l] += s.a_factor * f[c][l];
        s.next[c][first + l] = s.x[c][first + l] + s.d[c][first + l];
      }
    }
  }
}

/// Offsets +1, +columns, +columns+1 of the valence-6 stencil; `rest` of each. Forces of a row are
/// complete when it has been done itself. Every vertex adds in ascending neighbour index, as the
/// gather does.
void once(const PlainSheet& shared, int columns, const float* rest) {
  const PlainSheet s = shared;
  constexpr int most = 4096;
  static thread_local float pull[3][3][most];  // by offset and component
  const int rows = s.vertices / columns;
  const int step[3] = {1, columns, columns + 1};
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < columns; ++i) s.force[c][i] = 0;
  }
  for (int r = 0; r < rows; ++r) {
    const bool last = r + 1 == rows;
    const int i0 = r * columns;
    if (!last) {
      for (int c = 0; c < 3; ++c) {
        for (int i = i0 + columns; i < i0 + 2 * columns; ++i) s.force[c][i] = 0;
      }
    }
    for (int first = 0; first < columns; first += most) {
      const int whole = columns - first < most ? columns - first : most;
      int count[3];
      for (int k = 0; k < 3; ++k) {
        const int end = k == 1 ? columns : columns - 1;
        count[k] = last && k > 0 ? 0 : (end - first < whole ? end - first : whole);
        float* px = pull[k][0];
        float* py = pull[k][1];
        float* pz = pull[k][2];
#pragma omp simd
        for (int l = 0; l < count[k]; ++l) {
          const int i = i0 + first + l, j = i + step[k];
          const float x = s.x[0][j] - s.x[0][i], y = s.x[1][j] - s.x[1][i],
                      z = s.x[2][j] - s.x[2][i];
          const float t = tension_of(x, y, z, s.stiffness, rest[k]);
          px[l] = t * x;
          py[l] = t * y;
          pz[l] = t * z;
        }
      }
      for (int c = 0; c < 3; ++c) {
        float* here = s.force[c] + i0 + first;
        for (int k = 0; k < 3; ++k) {
          const float* p = pull[k][c];
          if (k == 0) {
#pragma omp simd
            for (int l = 0; l < count[k]; ++l) here[l + 1] -= p[l];
          }
#pragma omp simd
          for (int l = 0; l < count[k]; ++l) here[l] += p[l];
        }
        for (int k = 2; k > 0; --k) {
          const float* p = pull[k][c];
          float* there = here + step[k];
#pragma omp simd
          for (int l = 0; l < count[k]; ++l) there[l] -= p[l];
        }
      }
    }
    for (int c = 0; c < 3; ++c) {
#pragma omp simd
      for (int i = i0; i < i0 + columns; ++i) {
        s.d[c][i] += s.a_factor * s.force[c][i];
        s.next[c][i] = s.x[c][i] + s.d[c][i];
      }
    }
  }
}

}  // namespace weft::bench::WEFT_LAYOUTS_NS
