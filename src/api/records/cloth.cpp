#include "api/records/cloth.h"

#include <algorithm>
#include <cmath>

#include "api/context/context_state.h"
#include "api/context/vector_math.h"
#include "base/stable_sort_host.h"
#include "scene/check.h"
#include "scene/near_rest_pairs.h"
#include "scene/trigonometry.h"

namespace weft::api {

const PinRecord* ClothRecord::pin_of(uint32_t vertex) const {
  const auto at = std::lower_bound(pins.begin(), pins.end(), vertex,
                                   [](const PinRecord& p, uint32_t v) { return p.vertex < v; });
  return at != pins.end() && at->vertex == vertex ? &*at : nullptr;
}

void check_collision_distance(double distance, const char* field) {
  if (distance <= most_collision_distance) return;
  throw InvalidInput(
      text("%s is %g m (particles meet within 1e12 m at most) give less", field, distance));
}

double collision_distance_of(const ClothRecord& cloth, const SelfCollisionDesc& desc) {
  return cloth.collision_distance > 0 ? cloth.collision_distance : desc.distance;
}

uint64_t excluded_pairs(const ClothRecord& cloth, const SelfCollisionDesc& desc) {
  if (!cloth.collides_itself) return 0;
  const double distance = collision_distance_of(cloth, desc);
  if (cloth.near_rest_distance != distance) {
    cloth.near_rest_pairs = scene::near_rest_pairs(cloth.cooked(), distance);
    cloth.near_rest_distance = distance;
  }
  return cloth.near_rest_pairs;
}

double3 posed(const ClothRecord& cloth, uint32_t vertex) {
  const double3 p = cloth.cooked().position_of(vertex);
  const auto row = [&](const double3& r) { return r.x * p.x + r.y * p.y + r.z * p.z; };
  return {row(cloth.rotation[0]) + cloth.translate.x, row(cloth.rotation[1]) + cloth.translate.y,
          row(cloth.rotation[2]) + cloth.translate.z};
}

double3 start_position(const ClothRecord& cloth, uint32_t vertex) {
  return cloth.positions.empty() ? posed(cloth, vertex) : cloth.positions[vertex];
}

double3 motion_offset(const PinMotion& m, double t) {
  const double s = scene::sine_cosine(m.omega * t).sine;
  return {m.velocity.x * t + m.amplitude.x * s, m.velocity.y * t + m.amplitude.y * s,
          m.velocity.z * t + m.amplitude.z * s};
}
double3 motion_velocity(const PinMotion& m, double t) {
  const double c = m.omega * scene::sine_cosine(m.omega * t).cosine;
  return {m.velocity.x + m.amplitude.x * c, m.velocity.y + m.amplitude.y * c,
          m.velocity.z + m.amplitude.z * c};
}

namespace {

void check_vertex(uint32_t vertex, uint32_t count, const char* field, uint32_t index) {
  if (vertex >= count) {
    throw InvalidInput(text("%s[%u] names vertex %u (the cloth has %u) give an index below that",
                            field, index, vertex, count));
  }
}

void set_pose(const Pose& pose, ClothRecord& cloth) {
  rotation_rows(pose.axis, pose.degrees, "pose", cloth.rotation);
  cloth.translate = checked_vector(pose.translate, "pose.translate");
}

void set_start(const ClothDesc& desc, uint32_t vertices, ClothRecord& cloth) {
  checked_vector(desc.velocity, "velocity");
  cloth.velocity = desc.velocity;
  if (!desc.positions.empty()) {
    scene::check_positions(desc.positions, "positions");
    if (desc.positions.count != vertices) {
      throw InvalidInput(
          text("positions has %u elements (the cloth has %u vertices) give one per "
               "vertex or none",
               desc.positions.count, vertices));
    }
    cloth.positions.resize(vertices);
    for (uint32_t v = 0; v < vertices; ++v) cloth.positions[v] = desc.positions[v];
  }
  if (!desc.velocities.empty()) {
    scene::check_view(desc.velocities, "velocities");
    if (desc.velocities.count != vertices) {
      throw InvalidInput(
          text("velocities has %u elements (the cloth has %u vertices) give one per "
               "vertex or none",
               desc.velocities.count, vertices));
    }
    cloth.velocities.resize(vertices);
    for (uint32_t v = 0; v < vertices; ++v) {
      checked_vector(desc.velocities[v], text("velocities[%u]", v).c_str());
      cloth.velocities[v] = desc.velocities[v];
    }
  }
}

void set_pins(const ClothDesc& desc, uint32_t vertices, ClothRecord& cloth) {
  scene::check_view(desc.pins, "pins");
  scene::check_view(desc.motions, "motions");
  for (uint32_t m = 0; m < desc.motions.count; ++m) {
    const PinMotion& motion = desc.motions[m];
    checked_vector(motion.velocity, text("motions[%u].velocity", m).c_str());
    checked_vector(motion.amplitude, text("motions[%u].amplitude", m).c_str());
    scene::check_finite(motion.omega, text("motions[%u].omega", m).c_str());
    cloth.motions.push_back(motion);
  }
  for (uint32_t i = 0; i < desc.pins.count; ++i) {
    const Pin& pin = desc.pins[i];
    check_vertex(pin.vertex, vertices, "pins", i);
    if (pin.motion != Pin::fixed && pin.motion >= desc.motions.count) {
      throw InvalidInput(
          text("pins[%u] names motion %u (there are %u) give an index below that or "
               "Pin::fixed",
               i, pin.motion, desc.motions.count));
    }
    PinRecord record;
    record.vertex = pin.vertex;
    record.motion = pin.motion == Pin::fixed ? -1 : static_cast<int32_t>(pin.motion);
    record.can_move = record.motion >= 0;
    record.base = start_position(cloth, pin.vertex);
    cloth.pins.push_back(record);
  }
  std::sort(cloth.pins.begin(), cloth.pins.end(),
            [](const PinRecord& a, const PinRecord& b) { return a.vertex < b.vertex; });
  for (size_t i = 1; i < cloth.pins.size(); ++i) {
    if (cloth.pins[i].vertex == cloth.pins[i - 1].vertex) {
      throw InvalidInput(text("vertex %u is pinned twice (a vertex has one pin) remove one",
                              cloth.pins[i].vertex));
    }
  }
}

}  // namespace

void checked_forces(View<VertexForce> forces, uint32_t vertices,
                    std::pmr::vector<VertexForce>& out) {
  scene::check_view(forces, "forces");
  for (uint32_t i = 0; i < forces.count; ++i) {
    check_vertex(forces[i].vertex, vertices, "forces", i);
    checked_vector(forces[i].force, text("forces[%u]", i).c_str());
    out.push_back(forces[i]);
  }
  weft::stable_sort(out.begin(), out.end(),
                    [](const VertexForce& a, const VertexForce& b) { return a.vertex < b.vertex; });
  size_t kept = 0;
  for (size_t i = 0; i < out.size(); ++i) {
    const VertexForce force = out[i];
    if (kept > 0 && out[kept - 1].vertex == force.vertex) {
      double3& sum = out[kept - 1].force;
      sum = {sum.x + force.force.x, sum.y + force.force.y, sum.z + force.force.z};
    } else {
      out[kept++] = force;
    }
  }
  out.resize(kept);
}

namespace {

/// The particles of a cloth along one axis, at the start: their middle, and how far most of
/// them are from it.
struct Spread {
  double middle, extent;
};
Spread spread_of(const ClothRecord& cloth, double double3::*axis) {
  const uint32_t vertices = cloth.cooked().vertices;
  if (vertices == 0) return {0, 0};
  const bool corners_do = cloth.cooked().is_grid && cloth.positions.empty();
  const uint32_t columns = corners_do ? cloth.cooked().grid.columns : 1;
  const uint32_t corner[4] = {0, columns - 1, vertices - columns, vertices - 1};
  Vector<double> at(corners_do ? 4 : vertices);
  for (uint32_t i = 0; i < at.size(); ++i) {
    at[i] = start_position(cloth, corners_do ? corner[i] : i).*axis;
  }
  const auto [low, high] = std::minmax_element(at.begin(), at.end());
  const double half = (*high - *low) / 2, middle = (*high + *low) / 2;
  if (corners_do || vertices < 3) return {middle, half};
  // Strays must not take the precision of the others: most are within `near` of the median.
  std::nth_element(at.begin(), at.begin() + ptrdiff_t(at.size() / 2), at.end());
  const double median = at[at.size() / 2];
  for (double& a : at) a = std::fabs(a - median);
  const auto most = at.begin() + ptrdiff_t(at.size() - 1 - std::max<size_t>(1, at.size() / 10));
  std::nth_element(at.begin(), most, at.end());
  const double near = *most;
  return half <= 4 * near ? Spread{middle, half} : Spread{median, 2 * near};
}

/// In whole metres, which every float holds exactly.
void set_origin(ClothRecord& cloth) {
  const Spread x = spread_of(cloth, &double3::x), y = spread_of(cloth, &double3::y),
               z = spread_of(cloth, &double3::z);
  cloth.origin = {std::nearbyint(x.middle), std::nearbyint(y.middle), std::nearbyint(z.middle)};
  cloth.rest_origin = cloth.origin;
  cloth.extent = std::max({x.extent, y.extent, z.extent});
}

}  // namespace

void fill_record(const ClothDesc& desc, ClothRecord& cloth) {
  if (!desc.fabric.impl()) {
    throw InvalidInput("fabric is empty (a cloth is an instance of one) cook a fabric first");
  }
  cloth.fabric = desc.fabric;
  cloth.cooked_fabric = &desc.fabric.impl()->cooked;
  const uint32_t vertices = cloth.cooked().vertices;
  set_pose(desc.pose, cloth);
  set_start(desc, vertices, cloth);
  for (const ClothNumber& number : cloth_numbers) {
    scene::check_not_negative(desc.*number.value, number.name);
  }
  check_collision_distance(desc.collision_distance, "collision_distance");
  scene::check_choice(int(desc.drag_model), 2, "drag_model", "central, lagged");
  scene::check_choice(desc.collides_itself, 2, "collides_itself", "0, 1");
  scene::check_choice(desc.collides_others, 2, "collides_others", "0, 1");
  static_cast<ClothSettings&>(cloth) = desc;
  cloth.user_data = desc.user_data;
  set_pins(desc, vertices, cloth);
  checked_forces(desc.forces, vertices, cloth.forces);
  set_origin(cloth);
}

void start_motions(ClothRecord& cloth, double time) {
  if (time == 0) return;
  for (const PinRecord& pin : cloth.pins) {
    if (pin.motion < 0) continue;
    if (cloth.positions.empty()) {
      cloth.positions.resize(cloth.cooked().vertices);
      for (uint32_t v = 0; v < cloth.cooked().vertices; ++v) cloth.positions[v] = posed(cloth, v);
    }
    double3& start = cloth.positions[pin.vertex];
    start = plus(start, motion_offset(cloth.motions[static_cast<size_t>(pin.motion)], time));
  }
}

void wake(ClothRecord& cloth) {
  cloth.asleep = false;
  cloth.calm = 0;
}

void notice_rest(ClothRecord& cloth, double dt, double substep) {
  if (cloth.sleep_speed <= 0 || cloth.asleep || cloth.pins_led) return;
  // However slowly its pins are led, they must not be left behind.
  for (const PinRecord& pin : cloth.pins) {
    if (pin.motion >= 0) return;
  }
  cloth.calm = cloth.furthest < cloth.sleep_speed * substep ? cloth.calm + dt : 0;
  if (cloth.calm <= 0 || cloth.calm < cloth.sleep_time) return;
  cloth.asleep = true;
  cloth.settling = substeps_to_settle;
}

}  // namespace weft::api
