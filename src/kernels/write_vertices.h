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
    LaneVec3<float, N> v;
    positions(first, lanes, v);
    if (job.out_last.format != VertexFormat::none) {
      LaneVec3<float, N> last;
      lanes.each([&](int l) WEFT_LANE { last.set(l, job.last[within(first + l)]); });
      write(job.out_last, first, count, last, 1.0f);
    }
    if (job.last != nullptr) {
      for (int l = 0; l < count; ++l) job.last[first + l] = v.get(l);
    }
    write(job.out_position, first, count, v, 1.0f);
    if (job.out_normal.format != VertexFormat::none) {
      lanes.each([&](int l) WEFT_LANE {
        const Vec3<T> n = load(job.normal, element(first + l));
        v.set(l, {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
      });
      write(job.out_normal, first, count, v, 0.0f);
    }
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
  template <int N>
  WEFT_HD void positions(int first, Lanes<N> lanes, LaneVec3<float, N>& v) const {
    if (job.alpha == T(1)) {
      lanes.each([&](int l) WEFT_LANE { v.set(l, shifted(load(job.now, element(first + l)))); });
      return;
    }
    lanes.each([&](int l) WEFT_LANE {
      const int i = element(first + l);
      const Vec3<T> a = load(job.before, i), b = load(job.now, i);
      v.set(l, shifted(a + job.alpha * (b - a)));
    });
  }

  /// `fourth`: what a format with four components has behind the third.
  template <int N>
  WEFT_HD static void write(const VertexAttribute& to, int first, int count,
                            const LaneVec3<float, N>& v, float fourth) {
    char* at = to.data + int64_t(first) * to.stride;
    switch (to.format) {
      case VertexFormat::none:
        return;
      case VertexFormat::f32x3:
        for (int l = 0; l < count; ++l, at += to.stride) {
          const float out[3] = {v.x[l], v.y[l], v.z[l]};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::f32x4:
        for (int l = 0; l < count; ++l, at += to.stride) {
          const float out[4] = {v.x[l], v.y[l], v.z[l], fourth};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::f16x4:
        for (int l = 0; l < count; ++l, at += to.stride) {
          const uint16_t out[4] = {half_of(v.x[l]), half_of(v.y[l]), half_of(v.z[l]),
                                   half_of(fourth)};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::snorm8x4:
        for (int l = 0; l < count; ++l, at += to.stride) {
          const int8_t out[4] = {static_cast<int8_t>(snorm_of(v.x[l], 127.0f)),
                                 static_cast<int8_t>(snorm_of(v.y[l], 127.0f)),
                                 static_cast<int8_t>(snorm_of(v.z[l], 127.0f)), 0};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::snorm16x4:
        for (int l = 0; l < count; ++l, at += to.stride) {
          const int16_t out[4] = {static_cast<int16_t>(snorm_of(v.x[l], 32767.0f)),
                                  static_cast<int16_t>(snorm_of(v.y[l], 32767.0f)),
                                  static_cast<int16_t>(snorm_of(v.z[l], 32767.0f)), 0};
          __builtin_memcpy(at, out, sizeof out);
        }
        return;
      case VertexFormat::oct16x2:
        for (int l = 0; l < count; ++l, at += to.stride) {
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
