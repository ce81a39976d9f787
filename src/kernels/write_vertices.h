// Positions and normals into a vertex buffer: caller order, single precision or less, any layout.
#pragma once

#include "base/lanes.h"
#include "kernels/vertex_formats.h"
#include "state/vertices.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
struct WriteVertices {
  VertexJob<T> job;

  /// Block b is vertices [32 b, 32 b + 32).
  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const int first = block * block_size + lane0;
    const int count = job.vertices - first < N ? job.vertices - first : N;
    if (count <= 0) return;
    LaneVec3<float, N> v, n;
    positions(first, lanes, v);
    if (job.out_last.format != VertexFormat::none) {
      LaneVec3<float, N> last;
      lanes.each([&](int l) WEFT_LANE { last.set(l, job.last[within(first + l)]); });
      write(job.out_last, first, count, lanes, last, 1.0f);
    }
    if (job.last != nullptr) {
      for (int l = 0; l < count; ++l) job.last[first + l] = v.get(l);
    }
    if (job.out_normal.format == VertexFormat::none) {
      return write(job.out_position, first, count, lanes, v, 1.0f);
    }
    normals(first, lanes, n);
    if (lie_together()) return write_together(first, count, lanes, v, n);
    write(job.out_position, first, count, lanes, v, 1.0f);
    write(job.out_normal, first, count, lanes, n, 0.0f);
  }

 private:
  /// Lanes behind the last vertex stand for it.
  WEFT_HD int within(int v) const { return v < job.vertices ? v : job.vertices - 1; }
  WEFT_HD int element(int v) const {
    const int i = within(v);
    return job.storage != nullptr ? static_cast<int>(job.storage[i]) : i;
  }
  WEFT_HD Vec3<float> shifted(Vec3<T> x) const {
    return {static_cast<float>(double(x.x) + job.shift.x),
            static_cast<float>(double(x.y) + job.shift.y),
            static_cast<float>(double(x.z) + job.shift.z)};
  }
  /// Whether vertices [first, first + N) are elements first, first + 1, ...
  template <int N>
  WEFT_HD bool in_order(int first, Lanes<N>) const {
    return job.storage == nullptr && first + N <= job.vertices;
  }
  WEFT_HD static Vec3<float> narrowed(Vec3<T> n) {
    return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  }
  /// Whether adding the shift would change nothing.
  WEFT_HD bool is_exact() const {
    return job.shift.x == 0.0 && job.shift.y == 0.0 && job.shift.z == 0.0;
  }
  template <int N>
  WEFT_HD void positions(int first, Lanes<N> lanes, LaneVec3<float, N>& v) const {
    if (job.alpha != T(1)) {
      lanes.each([&](int l) WEFT_LANE {
        const int i = element(first + l);
        const Vec3<T> a = load(job.before, i), b = load(job.now, i);
        v.set(l, shifted(a + job.alpha * (b - a)));
      });
    } else if (in_order(first, lanes) && is_exact()) {
      const Vec3Array<T> now = job.now;
      lanes.each([=, &v](int l) WEFT_LANE { v.set(l, narrowed(load(now, first + l))); });
    } else if (in_order(first, lanes)) {
      const Vec3Array<T> now = job.now;
      const Vec3<double> by = job.shift;
      lanes.each([=, &v](int l) WEFT_LANE {
        const Vec3<T> x = load(now, first + l);
        v.set(l, {static_cast<float>(double(x.x) + by.x), static_cast<float>(double(x.y) + by.y),
                  static_cast<float>(double(x.z) + by.z)});
      });
    } else {
      lanes.each([&](int l) WEFT_LANE { v.set(l, shifted(load(job.now, element(first + l)))); });
    }
  }
  template <int N>
  WEFT_HD void normals(int first, Lanes<N> lanes, LaneVec3<float, N>& n) const {
    const Vec3Array<T> normal = job.normal;
    if (in_order(first, lanes)) {
      lanes.each([=, &n](int l) WEFT_LANE { n.set(l, narrowed(load(normal, first + l))); });
    } else {
      lanes.each([&](int l) WEFT_LANE { n.set(l, narrowed(load(normal, element(first + l)))); });
    }
  }

  /// Two components of each lane side by side: a store of both at once.
  template <int N>
  struct Pairs {
    alignas(N == 1 ? 8 : 64) float of[2 * N];
    WEFT_HD Pairs(Lanes<N> lanes, const float* a, const float* b) {
      lanes.each([&](int l) WEFT_LANE {
        of[2 * l] = a[l];
        of[2 * l + 1] = b[l];
      });
    }
    WEFT_HD void put(char* at, int l) const { __builtin_memcpy(at, &of[2 * l], 8); }
  };

  /// Position and normal as six floats in a row, what many engines have: stores of 8 bytes.
  WEFT_HD bool lie_together() const {
    const VertexAttribute &x = job.out_position, &n = job.out_normal;
    return x.format == VertexFormat::f32x3 && n.format == VertexFormat::f32x3 &&
           x.stride == n.stride && n.data == x.data + 12;
  }
  template <int N>
  WEFT_HD void write_together(int first, int count, Lanes<N> lanes, const LaneVec3<float, N>& v,
                              const LaneVec3<float, N>& n) const {
    const Pairs<N> a(lanes, v.x, v.y), b(lanes, v.z, n.x), c(lanes, n.y, n.z);
    const int64_t stride = job.out_position.stride;
    char* at = job.out_position.data + int64_t(first) * stride;
    for (int l = 0; l < count; ++l, at += stride) {
      a.put(at, l);
      b.put(at + 8, l);
      c.put(at + 16, l);
    }
  }

  /// `fourth`: what a format with four components has behind the third.
  template <int N>
  WEFT_HD static void write(const VertexAttribute& to, int first, int count, Lanes<N> lanes,
                            const LaneVec3<float, N>& v, float fourth) {
    char* at = to.data + int64_t(first) * to.stride;
    const int64_t stride = to.stride;
    switch (to.format) {
      case VertexFormat::none:
        return;
      case VertexFormat::f32x3: {
        const Pairs<N> xy(lanes, v.x, v.y);
        for (int l = 0; l < count; ++l, at += stride) {
          xy.put(at, l);
          __builtin_memcpy(at + 8, &v.z[l], 4);
        }
        return;
      }
      case VertexFormat::f32x4: {
        const Pairs<N> xy(lanes, v.x, v.y);
        for (int l = 0; l < count; ++l, at += stride) {
          const float zw[2] = {v.z[l], fourth};
          xy.put(at, l);
          __builtin_memcpy(at + 8, zw, sizeof zw);
        }
        return;
      }
      case VertexFormat::f16x4:
        for (int l = 0; l < count; ++l, at += stride) {
          const uint16_t out[4] = {half_of(v.x[l]), half_of(v.y[l]), half_of(v.z[l]),
                                   half_of(fourth)};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::snorm8x4:
        for (int l = 0; l < count; ++l, at += stride) {
          const int8_t out[4] = {static_cast<int8_t>(snorm_of(v.x[l], 127.0f)),
                                 static_cast<int8_t>(snorm_of(v.y[l], 127.0f)),
                                 static_cast<int8_t>(snorm_of(v.z[l], 127.0f)), 0};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::snorm16x4:
        for (int l = 0; l < count; ++l, at += stride) {
          const int16_t out[4] = {static_cast<int16_t>(snorm_of(v.x[l], 32767.0f)),
                                  static_cast<int16_t>(snorm_of(v.y[l], 32767.0f)),
                                  static_cast<int16_t>(snorm_of(v.z[l], 32767.0f)), 0};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::oct16x2:
        for (int l = 0; l < count; ++l, at += stride) {
          const Octahedral o = octahedral_of(v.get(l));
          const int16_t out[2] = {static_cast<int16_t>(snorm_of(o.u, 32767.0f)),
                                  static_cast<int16_t>(snorm_of(o.v, 32767.0f))};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
