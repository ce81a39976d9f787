// Pins and colliders that an engine leads: what it gives once a frame, and where the steps inside
// of the frame find it.
#include <algorithm>
#include <numeric>

#include "api/context/vector_math.h"
#include "api/world/state.h"

namespace weft {
inline namespace v0 {

/// Where a pin is at a time, its motion included.
static double3 place_at(const api::ClothRecord& cloth, const api::PinRecord& pin, double time) {
  if (pin.motion < 0) return pin.base;
  return api::plus(pin.base,
                   api::motion_offset(cloth.motions[static_cast<size_t>(pin.motion)], time));
}

/// Whether a pin is on its way to a place, or there, already.
static bool goes_to(const api::PinRecord& pin, const double3& place) {
  if (pin.motion >= 0) return false;
  const bool at_rest = pin.way.state == api::Way<double3>::State::none;
  return api::same(at_rest ? pin.base : pin.way.to, place);
}

/// A new pin on every free vertex of an ascending list, where the vertex is now.
Status World::Impl::pin_free(api::ClothRecord& cloth, const std::pmr::vector<uint32_t>& vertices) {
  std::pmr::vector<api::PinRecord> pins(&context->memory);
  pins.reserve(cloth.pins.size() + vertices.size());
  Vector<double3> now;
  auto next = cloth.pins.begin();
  for (const uint32_t v : vertices) {
    while (next != cloth.pins.end() && next->vertex < v) pins.push_back(*next++);
    const bool pinned = (next != cloth.pins.end() && next->vertex == v) ||
                        (!pins.empty() && pins.back().vertex == v);
    if (pinned) continue;
    if (now.empty()) {
      Status status = ensure_readable();
      if (status == Status::ok) status = arena->read(cloth, api::StateArray::position, now);
      if (status != Status::ok) return status;
    }
    api::PinRecord pin;
    pin.vertex = v;
    pin.base = api::plus(cloth.origin, now[v]);
    pins.push_back(pin);
  }
  if (now.empty()) return Status::ok;
  pins.insert(pins.end(), next, cloth.pins.end());
  cloth.pins = std::move(pins);
  cloth.repinned();
  return Status::ok;
}

Status World::Impl::lead_pins(api::ClothRecord& cloth, View<uint32_t> vertices,
                              const PointView& targets) {
  // Ascending, the last target of a vertex last.
  std::pmr::vector<uint32_t> order_of(vertices.count, &context->memory);
  std::iota(order_of.begin(), order_of.end(), 0u);
  const auto before = [&](uint32_t a, uint32_t b) {
    return vertices[a] != vertices[b] ? vertices[a] < vertices[b] : a < b;
  };
  if (!std::is_sorted(order_of.begin(), order_of.end(), before)) {
    std::sort(order_of.begin(), order_of.end(), before);
  }
  std::pmr::vector<uint32_t> sorted(&context->memory);
  sorted.reserve(vertices.count);
  for (const uint32_t i : order_of) sorted.push_back(vertices[i]);
  const size_t pins_before = cloth.pins.size();
  if (const Status status = pin_free(cloth, sorted); status != Status::ok) return status;
  bool changes = cloth.pins.size() != pins_before;
  auto pin = cloth.pins.begin();
  for (const uint32_t i : order_of) {
    while (pin->vertex < vertices[i]) ++pin;
    const double3 place = targets[i];
    if (pin->can_move && goes_to(*pin, place)) continue;
    if (!pin->can_move && pin->motion < 0 && api::same(pin->base, place)) continue;
    changes = true;
    dirty |= !pin->can_move || starting;  // the start displacements depend on it
    const double3 set_out = place_at(cloth, *pin, time + time_owed);  // when the last frame ended
    pin->base = place_at(cloth, *pin, time);
    pin->motion = -1;
    pin->can_move = cloth.pins_led = true;
    pin->way.give(set_out, place);
  }
  if (changes) {
    api::wake(cloth);
    probed = false;
  }
  if (cloth.pins.size() != pins_before) dirty = true;
  return Status::ok;
}

void World::Impl::aim(double way) {
  const auto due = [way](const auto& led) {
    return way >= 1 || led.state == std::decay_t<decltype(led)>::State::late;
  };
  for (const ClothId id : order) {
    api::ClothRecord& cloth = *cloths[id.index];
    if (!cloth.pins_led) continue;
    for (api::PinRecord& pin : cloth.pins) {
      const auto& led = pin.way;
      if (led.state == api::Way<double3>::State::none) continue;
      pin.target =
          due(led) ? led.to : api::plus(led.from, api::times(way, api::minus(led.to, led.from)));
      pin.gliding = true;
    }
  }
  for (api::ColliderRecord& c : colliders) {
    if (!c.id || c.way.state == api::Way<api::Placed>::State::none) continue;
    c.target = due(c.way) ? c.way.to : api::between(c.way.from, c.way.to, way);
    c.gliding = true;
  }
}

void World::Impl::arrive(double way) {
  const auto arrives = [way](auto& led) {
    if (way >= 1 || led.state == std::decay_t<decltype(led)>::State::late) led.arrive();
  };
  for (api::ClothRecord* cloth : built->cloths) {
    if (!cloth->pins_led) continue;
    cloth->pins_led = false;
    for (api::PinRecord& pin : cloth->pins) {
      if (!pin.gliding) continue;
      pin.base = pin.target;
      pin.gliding = false;
      arrives(pin.way);
      cloth->pins_led |= pin.way.state != api::Way<double3>::State::none;
    }
  }
  for (api::ColliderRecord& c : colliders) {
    c.went = c.id && c.gliding;
    if (!c.went) continue;
    c.was = c.placed;
    c.placed = c.target;
    c.since = time;
    c.gliding = false;
    arrives(c.way);
  }
}

void World::Impl::end_inputs() {
  for (const ClothId id : order) {
    api::ClothRecord& cloth = *cloths[id.index];
    if (!cloth.pins_led) continue;
    for (api::PinRecord& pin : cloth.pins) pin.way.hold();
  }
  for (api::ColliderRecord& c : colliders) c.way.hold();
}

}  // namespace v0
}  // namespace weft
