// Colliders of every shape below the cloths: smooth, rough, moving, turned by the caller.
#pragma once

#include "samples/effects/effect.h"

namespace weft::samples {

constexpr double far_away = 1000;  ///< m: out of reach of every cloth

enum class Way { smooth, rough, moving, turning, fast };
constexpr const char* suffix_of(Way way) {
  constexpr const char* names[] = {"", "_rough", "_moving", "_turning", "_fast"};
  return names[int(way)];
}

/// All but a smooth collider have friction.
template <class Desc>
void go(Desc& collider, Way way) {
  if (way != Way::smooth) collider.friction = 0.5;
  if (way == Way::moving) collider.velocity = {0.25, 0, 0.125};
  if (way == Way::fast) collider.velocity = {9, 3, 15};
}
/// The same in a scene file, behind its shape.
inline std::string keys_of(const std::string& shape, Way way) {
  if (way == Way::turning) return "";  // a scene's colliders do not turn
  std::string keys = "\"colliders\": [{" + shape;
  if (way != Way::smooth) keys += R"(, "friction": 0.5)";
  if (way == Way::moving) keys += R"(, "velocity": [0.25, 0, 0.125])";
  return keys + "}]";
}
inline void turn(Stage& s, int frame) {
  const Pose pose{{0.2, 0.1, 1}, 1.5 * frame, {0.002 * frame, 0, 0.004 * frame}};
  for (const ColliderId id : s.colliders) check(s.world.move_collider(id, pose));
}

inline void add(Stage& s, const SphereDesc& d) {
  s.colliders.push_back(take(s.world.create_sphere(d)));
}
inline void add(Stage& s, const PlaneDesc& d) {
  s.colliders.push_back(take(s.world.create_plane(d)));
}
inline void add(Stage& s, const CapsuleDesc& d) {
  s.colliders.push_back(take(s.world.create_capsule(d)));
}
inline void add(Stage& s, const CylinderDesc& d) {
  s.colliders.push_back(take(s.world.create_cylinder(d)));
}
inline void add(Stage& s, const BoxDesc& d) { s.colliders.push_back(take(s.world.create_box(d))); }

// Each `depth` below the place where the cloths lie on it.
inline SphereDesc sphere(double depth) { return {{0.5, 0.5, -0.4 - depth}, 0.4}; }
inline PlaneDesc plane(double depth) { return {{0, 0, 1}, -depth}; }
inline CapsuleDesc capsule(double depth) {
  return {{0.2, 0.5, -0.2 - depth}, {0.8, 0.5, -0.2 - depth}, 0.2};
}
inline CylinderDesc cylinder(double depth) {
  return {{0.5, 0.5, -1 - depth}, {0.5, 0.5, -depth}, 0.3};
}
inline BoxDesc box(double depth) { return {{0.5, 0.5, -0.2 - depth}, {0.3, 0.3, 0.2}}; }

template <auto shape, Way way>
void put(Stage& s) {
  auto collider = shape(0);
  go(collider, way);
  add(s, collider);
}
template <auto shape>
void put_far(Stage& s) {
  auto collider = shape(far_away);
  go(collider, Way::rough);
  add(s, collider);
}

template <auto shape, Way way>
Effect collider(const std::string& name, const std::string& keys, const char* line = nullptr) {
  return {.name = name + suffix_of(way),
          .used = {.line = line,
                   .furnish = put<shape, way>,
                   .lead = way == Way::turning ? turn : nullptr},
          .scene_keys = keys_of("\"" + name + "\": " + keys, way)};
}
/// One shape in every way; null lines are not timed.
template <auto shape>
void append_shape(std::vector<Effect>& all, const char* name, const char* keys, const char* line,
                  const char* rough_line = nullptr, const char* moving_line = nullptr) {
  all.push_back(collider<shape, Way::smooth>(name, keys, line));
  all.back().null = {{.furnish = put_far<shape>}};
  all.push_back(collider<shape, Way::rough>(name, keys, rough_line));
  all.push_back(collider<shape, Way::moving>(name, keys, moving_line));
  all.push_back(collider<shape, Way::turning>(name, keys));
}
inline std::vector<Effect> shape_effects() {
  std::vector<Effect> all;
  append_shape<plane>(all, "plane", R"({"normal": [0, 0, 1], "offset": 0})",
                      "plane, all of the sheet on it", "plane with friction, all on it");
  append_shape<sphere>(all, "sphere", R"({"center": [0.5, 0.5, -0.4], "radius": 0.4})",
                       "sphere, used", "sphere with friction, used", "moving sphere, used");
  append_shape<capsule>(all, "capsule",
                        R"({"a": [0.2, 0.5, -0.2], "b": [0.8, 0.5, -0.2], "radius": 0.2})",
                        "capsule, used");
  append_shape<cylinder>(all, "cylinder",
                         R"({"a": [0.5, 0.5, -1], "b": [0.5, 0.5, 0], "radius": 0.3})",
                         "cylinder, used");
  append_shape<box>(all, "box", R"({"center": [0.5, 0.5, -0.2], "half": [0.3, 0.3, 0.2]})",
                    "box, used");
  return all;
}

inline void put_sphere_and_plane(Stage& s) {
  add(s, sphere(0));
  add(s, plane(0.3));
}
inline void put_both_far(Stage& s) {
  add(s, sphere(far_away));
  add(s, plane(far_away));
}
inline Effect sphere_and_plane() {
  return {.name = "sphere_and_plane",
          .used = {.line = "sphere and plane, used", .furnish = put_sphere_and_plane},
          .null = {{.line = "sphere and plane, out of reach", .furnish = put_both_far}},
          .scene_keys = R"("colliders": [
            {"sphere": {"center": [0.5, 0.5, -0.4], "radius": 0.4}},
            {"plane": {"normal": [0, 0, 1], "offset": -0.3}}])"};
}

/// 8 x 8 of them side by side.
inline void put_spheres(Stage& s, double depth, double radius) {
  for (int i = 0; i < 64; ++i) {
    add(s, SphereDesc{{(i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8, -depth}, radius});
  }
}
inline Effect many_spheres() {
  return {
      .name = "many_spheres",
      .used = {.line = "64 spheres, used", .furnish = [](Stage& s) { put_spheres(s, 0.05, 0.06); }},
      .null = {{.line = "64 spheres, out of reach",
                .furnish = [](Stage& s) { put_spheres(s, far_away, 0.05); }}},
      .timed = {{.line = "64 spheres, near but not touched",
                 .furnish = [](Stage& s) { put_spheres(s, 0.06, 0.05); }}}};
}

/// One of each shape, small enough to stand side by side.
template <Way way>
void put_all_shapes(Stage& s) {
  const auto put_one = [&](auto collider) {
    go(collider, way);
    add(s, collider);
  };
  put_one(SphereDesc{{0.2, 0.2, -0.25}, 0.2});
  put_one(PlaneDesc{{0.1, 0, 1}, -0.4});
  put_one(CapsuleDesc{{0.6, 0.1, -0.2}, {0.9, 0.2, -0.1}, 0.08});
  put_one(CylinderDesc{{0.5, 0.6, -0.3}, {0.5, 0.5, -0.08}, 0.1});
  put_one(BoxDesc{{0.8, 0.8, -0.2}, {0.1, 0.1, 0.12}, {1, 2, 3}, 30});
}
template <Way way>
Effect all_shapes() {
  return {.name = std::string("all_shapes") + suffix_of(way),
          .used = {.furnish = put_all_shapes<way>, .lead = way == Way::turning ? turn : nullptr}};
}

inline std::vector<Effect> group_effects() {
  return {sphere_and_plane(),         many_spheres(),
          all_shapes<Way::rough>(),   all_shapes<Way::moving>(),
          all_shapes<Way::turning>(), all_shapes<Way::fast>()};
}

}  // namespace weft::samples
