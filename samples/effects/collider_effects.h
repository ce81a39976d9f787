// Colliders of every shape below the cloths: smooth, rough, moving, turned by the caller.
#pragma once

#include "samples/effects/effect.h"

namespace weft::samples {

constexpr double far_away = 1000;  ///< m: out of reach of every cloth

enum class Way { smooth, rough, moving, turning, fast };
/// All but a smooth collider have friction.
template <class Desc>
void go(Desc& collider, Way way) {
  if (way != Way::smooth) collider.friction = 0.5;
  if (way == Way::moving) collider.velocity = {0.25, 0, 0.125};
  if (way == Way::fast) collider.velocity = {9, 3, 15};
}
/// The same in a scene file, behind the shape.
constexpr const char* keys_of(Way way) {
  if (way == Way::smooth) return "}]";
  if (way == Way::rough) return R"(, "friction": 0.5}])";
  return R"(, "friction": 0.5, "velocity": [0.25, 0, 0.125]}])";
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

/// `keys`: the shape in a scene file, which cannot say that a collider turns.
template <auto shape, Way way>
constexpr Effect collider(const char* name, const char* keys, const char* line = nullptr) {
  Effect effect{.name = name, .used = {.line = line, .furnish = put<shape, way>}};
  if (way == Way::smooth) effect.null[0] = {.furnish = put_far<shape>};
  if (way == Way::turning) {
    effect.used.lead = turn;
  } else {
    const char* const pieces[] = {R"("colliders": [{)", keys, keys_of(way)};
    for (int i = 0; i < 3; ++i) effect.scene_keys[i] = pieces[i];
  }
  return effect;
}

inline constexpr const char* plane_keys = R"("plane": {"normal": [0, 0, 1], "offset": 0})";
inline constexpr const char* sphere_keys =
    R"("sphere": {"center": [0.5, 0.5, -0.4], "radius": 0.4})";
inline constexpr const char* capsule_keys =
    R"("capsule": {"a": [0.2, 0.5, -0.2], "b": [0.8, 0.5, -0.2], "radius": 0.2})";
inline constexpr const char* cylinder_keys =
    R"("cylinder": {"a": [0.5, 0.5, -1], "b": [0.5, 0.5, 0], "radius": 0.3})";
inline constexpr const char* box_keys =
    R"("box": {"center": [0.5, 0.5, -0.2], "half": [0.3, 0.3, 0.2]})";

inline constexpr Effect shape_effects[] = {
    collider<plane, Way::smooth>("plane", plane_keys, "plane, all of the sheet on it"),
    collider<plane, Way::rough>("plane_rough", plane_keys, "plane with friction, all on it"),
    collider<plane, Way::moving>("plane_moving", plane_keys),
    collider<plane, Way::turning>("plane_turning", plane_keys),
    collider<sphere, Way::smooth>("sphere", sphere_keys, "sphere, used"),
    collider<sphere, Way::rough>("sphere_rough", sphere_keys, "sphere with friction, used"),
    collider<sphere, Way::moving>("sphere_moving", sphere_keys, "moving sphere, used"),
    collider<sphere, Way::turning>("sphere_turning", sphere_keys),
    collider<capsule, Way::smooth>("capsule", capsule_keys, "capsule, used"),
    collider<capsule, Way::rough>("capsule_rough", capsule_keys),
    collider<capsule, Way::moving>("capsule_moving", capsule_keys),
    collider<capsule, Way::turning>("capsule_turning", capsule_keys),
    collider<cylinder, Way::smooth>("cylinder", cylinder_keys, "cylinder, used"),
    collider<cylinder, Way::rough>("cylinder_rough", cylinder_keys),
    collider<cylinder, Way::moving>("cylinder_moving", cylinder_keys),
    collider<cylinder, Way::turning>("cylinder_turning", cylinder_keys),
    collider<box, Way::smooth>("box", box_keys, "box, used"),
    collider<box, Way::rough>("box_rough", box_keys),
    collider<box, Way::moving>("box_moving", box_keys),
    collider<box, Way::turning>("box_turning", box_keys),
};

inline void put_sphere_and_plane(Stage& s) {
  add(s, sphere(0));
  add(s, plane(0.3));
}
inline void put_both_far(Stage& s) {
  add(s, sphere(far_away));
  add(s, plane(far_away));
}
inline constexpr Effect sphere_and_plane{
    .name = "sphere_and_plane",
    .used = {.line = "sphere and plane, used", .furnish = put_sphere_and_plane},
    .null = {{.line = "sphere and plane, out of reach", .furnish = put_both_far}},
    .scene_keys = {R"("colliders": [
            {"sphere": {"center": [0.5, 0.5, -0.4], "radius": 0.4}},
            {"plane": {"normal": [0, 0, 1], "offset": -0.3}}])"}};

/// 8 x 8 of them side by side.
inline void put_spheres(Stage& s, double depth, double radius) {
  for (int i = 0; i < 64; ++i) {
    add(s, SphereDesc{{(i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8, -depth}, radius});
  }
}
inline constexpr Effect many_spheres{
    .name = "many_spheres",
    .used = {.line = "64 spheres, used", .furnish = [](Stage& s) { put_spheres(s, 0.05, 0.06); }},
    .null = {{.line = "64 spheres, out of reach",
              .furnish = [](Stage& s) { put_spheres(s, far_away, 0.05); }}},
    .timed = {{.line = "64 spheres, near but not touched",
               .furnish = [](Stage& s) { put_spheres(s, 0.06, 0.05); }}}};

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

/// Cloths on a layer of their own, for some of the colliders to be on.
inline void choose_layer(ClothDesc& d) { d.collision_layers = 2; }
template <uint32_t layers, class Desc>
Desc on_layers(Desc collider) {
  collider.layers = layers;
  return collider;
}
inline void put_on_other_layers(Stage& s) {
  add(s, on_layers<1>(sphere(0)));
  add(s, on_layers<4>(plane(0)));
  add(s, on_layers<0>(capsule(0)));
  add(s, on_layers<5>(cylinder(0)));
  add(s, on_layers<~2u>(box(0)));
}
inline void put_on_layers(Stage& s) {
  add(s, on_layers<1>(box(0)));
  add(s, on_layers<4>(sphere(-0.2)));
  add(s, on_layers<3>(sphere(0)));
  add(s, on_layers<4>(plane(0)));
  add(s, on_layers<~0u>(plane(0.3)));
}
inline constexpr Effect collider_layers{.name = "collider_layers",
                                        .used = {.line = "5 colliders of which 2 are met",
                                                 .dress = choose_layer,
                                                 .furnish = put_on_layers},
                                        .null = {{.line = "5 colliders on other layers",
                                                  .dress = choose_layer,
                                                  .furnish = put_on_other_layers}},
                                        .cloth_keys = R"("collision": {"layers": 2})",
                                        .scene_keys = {R"("colliders": [
            {"box": {"center": [0.5, 0.5, -0.2], "half": [0.3, 0.3, 0.2]}, "layers": 1},
            {"sphere": {"center": [0.5, 0.5, -0.2], "radius": 0.4}, "layers": 4},)",
                                                       R"(
            {"sphere": {"center": [0.5, 0.5, -0.4], "radius": 0.4}, "layers": 3},
            {"plane": {"normal": [0, 0, 1], "offset": 0}, "layers": 4},
            {"plane": {"normal": [0, 0, 1], "offset": -0.3}}])"}};

inline constexpr Effect group_effects[] = {
    sphere_and_plane,
    many_spheres,
    collider_layers,
    {.name = "all_shapes_rough", .used = {.furnish = put_all_shapes<Way::rough>}},
    {.name = "all_shapes_moving", .used = {.furnish = put_all_shapes<Way::moving>}},
    {.name = "all_shapes_turning", .used = {.furnish = put_all_shapes<Way::turning>, .lead = turn}},
    {.name = "all_shapes_fast", .used = {.furnish = put_all_shapes<Way::fast>}}};

}  // namespace weft::samples
