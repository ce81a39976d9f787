#include "api/arena/tethers.h"

#include <cmath>
#include <limits>

#include "base/message_host.h"

namespace weft::api {

namespace {

/// Worked out once for the pins of a cloth.
const scene::NearestPins& nearest_pins(const ClothRecord& cloth) {
  std::shared_ptr<const void>& kept = cloth.kept[static_cast<int>(Part::tethers)];
  if (!kept) {
    std::pmr::memory_resource* memory = cloth.pins.get_allocator().resource();
    scene::Array<uint32_t> pins(memory);
    for (const PinRecord& pin : cloth.pins) pins.push_back(pin.vertex);
    kept = std::allocate_shared<const scene::NearestPins>(
        std::pmr::polymorphic_allocator<scene::NearestPins>(memory),
        scene::nearest_pins(cloth.cooked(), pins, memory));
  }
  return *static_cast<const scene::NearestPins*>(kept.get());
}

bool is_free(const ClothRecord& cloth, uint32_t v) {
  return !cloth.pin_of(v) && std::isfinite(cloth.cooked().mass_of(v));
}

/// Of a block; those without a tether do not count.
template <class T>
int32_t common_pin(const int32_t* pin, const T* limit) {
  int32_t common = pin[0];
  bool found = false;
  for (int l = 0; l < block_size; ++l) {
    if (std::isinf(limit[l])) continue;
    if (found && pin[l] != common) return several_pins;
    common = pin[l];
    found = true;
  }
  return common;
}

}  // namespace

template <class T>
void TethersPart::fill(const ClothRecord& cloth, int64_t first, int, Tethers<T>& to) {
  int32_t* pin = writable(to.pin) + first;
  T* limit = writable(to.limit) + first;
  for (int i = 0; i < slices_of(cloth) * block_size; ++i) {
    pin[i] = cloth.first() + i;
    limit[i] = std::numeric_limits<T>::infinity();
  }
  const scene::CookedFabric& fabric = cloth.cooked();
  const scene::NearestPins& nearest = nearest_pins(cloth);
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    if (nearest.pin[v] == scene::no_pin || !is_free(cloth, v)) continue;
    const uint32_t i = fabric.storage(v);
    pin[i] = cloth.first() + static_cast<int32_t>(fabric.storage(nearest.pin[v]));
    limit[i] = static_cast<T>(cloth.tether_scale * nearest.distance[v]);
  }
  for (int block = 0; block < slices_of(cloth); ++block) {
    writable(to.common)[first / block_size + block] =
        common_pin(pin + block * block_size, limit + block * block_size);
  }
}
template void TethersPart::fill(const ClothRecord&, int64_t, int, Tethers<float>&);
template void TethersPart::fill(const ClothRecord&, int64_t, int, Tethers<double>&);

void TethersPart::remarks(const ClothRecord& cloth, Vector<scene::CookedDiagnostic>& out) {
  const auto say = [&](uint32_t element, const Text& words) {
    out.push_back({Severity::warning, element, words});
  };
  if (cloth.tether_scale <= 0) {
    if (cloth.tether_compliance > 0) {
      say(0, "tether_compliance has no effect (tether_scale is 0, there are no tethers) set it");
    }
    return;
  }
  if (cloth.pins.empty()) {
    return say(0, "its tethers hold nothing (it has no pins) pin a vertex, or leave them out");
  }
  if (!used(cloth)) {
    return say(0, "its tethers hold nothing (all of its vertices are pinned) leave them out");
  }
  uint32_t lost = 0, first = 0;
  const scene::NearestPins& nearest = nearest_pins(cloth);
  for (uint32_t v = 0; v < cloth.cooked().vertices; ++v) {
    if (nearest.pin[v] != scene::no_pin || !is_free(cloth, v)) continue;
    if (lost++ == 0) first = v;
  }
  if (lost == 0) return;
  say(first, text("%u of its vertices have no tether, the first is %u (no path of edges leads from "
                  "a pin to them) pin a vertex of each piece, or leave them free",
                  lost, first));
}

}  // namespace weft::api
