// Constant forces of a cloth, as a part (parts.h).
#pragma once

#include "api/arena/image.h"
#include "plan/shape.h"

namespace weft::api {

struct ForcesPart {
  static constexpr Part part = Part::forces;
  static constexpr const char* name = "forces";
  static constexpr double flops = 3;

  static bool used(const ClothRecord& cloth) { return !cloth.forces.empty(); }
  static double number(const ClothRecord&) { return 0; }
  template <class T>
  static Forces<T>& arrays(Simulation<T>& sim) {
    return sim.forces;
  }
  template <class T>
  static void fill(const ClothRecord& cloth, int64_t first, int vector_stride, Forces<T>& to) {
    const VectorWriter<T> force(to.force, vector_stride);
    for (const VertexForce& f : cloth.forces) {
      force.set(first + int64_t(cloth.cooked().storage(f.vertex)), narrow<T>(f.force));
    }
  }
};

}  // namespace weft::api
