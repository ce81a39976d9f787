// Tethers of a cloth, as a part (parts.h).
#pragma once

#include "api/arena/image.h"
#include "base/memory_host.h"
#include "scene/nearest_pins.h"

namespace weft::api {

struct TethersPart {
  static constexpr Part part = Part::tethers;
  static constexpr const char* name = "tethers";
  static constexpr double flops = 25;

  static bool used(const ClothRecord& cloth) {
    return cloth.tether_scale > 0 && !cloth.pins.empty() &&
           cloth.pins.size() < cloth.cooked().vertices;
  }
  static double number(const ClothRecord& cloth) { return cloth.tether_compliance; }
  template <class T>
  static Tethers<T>& arrays(Simulation<T>& sim) {
    return sim.tethers;
  }
  template <class T>
  static void fill(const ClothRecord& cloth, int64_t first, int, Tethers<T>& to);
  static void remarks(const ClothRecord& cloth, Vector<scene::CookedDiagnostic>& out);
};

}  // namespace weft::api
