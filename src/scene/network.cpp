#include <algorithm>
#include <numeric>

#include "base/message_host.h"
#include "base/stable_sort_host.h"
#include "scene/check.h"
#include "scene/rows.h"

namespace weft::scene {

void cook_network(const NetworkDesc& desc, CookedFabric& fabric) {
  check_positions(desc.positions, "positions");
  check_view(desc.springs, "springs");
  check_material(desc.material, desc.positions.count);
  store_positions(desc.positions, desc.material.scale, fabric);
  fabric.stiffness = desc.material.stiffness;
  fabric.rest_length = desc.material.rest_length;

  Vector<SpringRecord> all;
  all.reserve(desc.springs.count);
  for (uint32_t i = 0; i < desc.springs.count; ++i) {
    const Spring& s = desc.springs[i];
    check_spring(s, i, desc.positions.count, "network");
    all.push_back({std::min(s.a, s.b), std::max(s.a, s.b), s.stiffness, s.rest_length});
  }
  Vector<uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0u);
  weft::stable_sort(order.begin(), order.end(), [&](uint32_t x, uint32_t y) {
    return all[x].a != all[y].a ? all[x].a < all[y].a : all[x].b < all[y].b;
  });
  Vector<SpringRecord> springs;
  springs.reserve(all.size());
  uint32_t repeats = 0, first = 0;
  for (const uint32_t i : order) {
    if (!springs.empty() && springs.back().a == all[i].a && springs.back().b == all[i].b) {
      first = repeats++ == 0 ? i : std::min(first, i);
      continue;
    }
    springs.push_back(all[i]);
  }
  if (repeats > 0) {
    fabric.diagnostics.push_back(
        {Severity::warning, first,
         text("%u springs join two vertices that a spring joins already, the first is %u, of "
              "vertices %u and %u (each is merged with the first of its pair) remove them, or add "
              "their stiffness to the first",
              repeats, first, all[first].a, all[first].b)});
  }
  build_rows(springs, fabric);
  set_masses(desc.material.mass, fabric);
}

}  // namespace weft::scene
