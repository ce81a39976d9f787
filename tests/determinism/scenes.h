// The scenes whose bits are compared. Their input is made with + - * / and square roots only, so
// that every compiler makes the same.
#pragma once

#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {

enum class Scene { grids, mesh, network, mixed };
constexpr Scene all_scenes[] = {Scene::grids, Scene::mesh, Scene::network, Scene::mixed};
inline const char* name(Scene scene) {
  const char* const names[] = {"grids", "mesh", "network", "mixed"};
  return names[int(scene)];
}

struct Variant {
  weft::Precision precision = weft::Precision::float32;
  weft::Form form = weft::Form::summed;
};

inline std::vector<weft::PinMotion> swaying() {
  return {{{0.25, 0, 0}, {0, 0.125, 0.0625}, 9}, {{0, 0, 0}, {0.1, 0, 0}, 23}};
}

/// Four sheets, one of each stencil, hanging from two pins of which one moves.
inline void add_grids(TestWorld& test, uint32_t rows, uint32_t columns) {
  const weft::Stencil stencils[] = {weft::Stencil::seed12, weft::Stencil::classic12,
                                    weft::Stencil::quad4, weft::Stencil::tri6};
  const std::vector<weft::PinMotion> motions = swaying();
  for (weft::Stencil stencil : stencils) {
    const uint32_t which = uint32_t(stencil);
    weft::GridDesc grid;
    grid.rows = rows + which;
    grid.columns = columns - which;
    grid.width = 1.5;
    grid.stencil = stencil;
    grid.material.stiffness = {80, 60, 40};
    grid.material.mass.value = 0.5;
    if (which == 1) grid.material.mass.kind = weft::Mass::Kind::density;
    const std::vector<weft::Pin> pins{{0, which % 2}, {grid.columns - 1, weft::Pin::fixed}};
    const std::vector<weft::VertexForce> forces{{grid.columns + 1, {0, 0.01, 0.02}}};
    weft::ClothDesc desc;
    desc.pose.axis = {1, 2, 0.5};
    desc.pose.degrees = 30 * which;
    desc.pose.translate = {2.0 * which, 0.3, -1.7};
    desc.velocity = {0, 0, 0.25};
    desc.pins = pins;
    desc.motions = motions;
    desc.forces = forces;
    desc.drag = which < 2 ? 1e-5 : 0;
    desc.drag_model = which == 0 ? weft::DragModel::central : weft::DragModel::lagged;
    desc.spring_damping = which == 2 ? 0.001 : 0;
    test.add(grid, desc);
  }
}

/// A crumpled triangle mesh with bend springs.
inline void add_mesh(TestWorld& test, uint32_t n) {
  reference::SplitMix random(21);
  std::vector<weft::double3> x;
  for (Vec p : reference::grid_positions(n, n))
    x.push_back(to_weft(p + random.noise(0.2 / n) + Vec{0, 0.25 * p.x * p.x, -0.9}));
  std::vector<uint32_t> indices;
  for (uint32_t r = 0; r + 1 < n; ++r)
    for (uint32_t c = 0; c + 1 < n; ++c) {
      const uint32_t i = r * n + c;
      for (uint32_t corner : {i, i + 1, i + n + 1, i, i + n + 1, i + n}) indices.push_back(corner);
    }
  const std::vector<weft::Pin> pins{{n / 2, weft::Pin::fixed}};
  weft::MeshDesc mesh;
  mesh.positions = weft::View<weft::double3>(x);
  mesh.indices = indices;
  mesh.bend = true;
  mesh.material.stiffness = {90, 0, 5};
  mesh.material.mass.value = 0.4;
  weft::ClothDesc desc;
  desc.pins = pins;
  desc.drag = 2e-5;
  desc.spring_damping = 0.0005;
  test.add(mesh, desc);
}

/// A random graph with valences from 0 to some dozens, unequal masses and stiffness.
inline void add_graph(TestWorld& test, uint32_t count) {
  reference::SplitMix random(33);
  NetworkParts parts;
  for (uint32_t i = 0; i < count; ++i) {
    parts.positions.push_back(random.noise(1));
    parts.masses.push_back(0.01 + 0.02 * random.uniform());
  }
  for (uint32_t i = 0; i < 4 * count; ++i) {
    const double u = random.uniform();  // low indices are hubs
    const uint32_t a = uint32_t(u * u * u * count), b = uint32_t(random.uniform() * count);
    if (a != b) parts.springs.push_back({a, b, 2 + 3 * random.uniform(), -1});
  }
  parts.pins = {3, count / 2};
  weft::ClothDesc desc;
  desc.drag = 1e-4;
  desc.drag_model = weft::DragModel::lagged;
  add_network(test, parts, desc);
}

/// A rough surface of triangles in the middle of it all.
inline void add_wavy_collider(TestWorld& test) {
  constexpr uint32_t n = 20;
  reference::SplitMix random(5);
  std::vector<weft::double3> x;
  for (Vec p : reference::grid_positions(n, n))
    x.push_back(to_weft(Vec{3 * p.x, 0.1 * random.uniform(), 3 * p.y}));
  std::vector<uint32_t> indices;
  for (uint32_t r = 0; r + 1 < n; ++r)
    for (uint32_t c = 0; c + 1 < n; ++c) {
      const uint32_t i = r * n + c;
      for (uint32_t corner : {i, i + n + 1, i + 1, i, i + n, i + n + 1}) indices.push_back(corner);
    }
  weft::ColliderMeshDesc desc;
  desc.positions = weft::View<weft::double3>(x);
  desc.indices = indices;
  desc.thickness = 0.02;
  weft::MeshColliderDesc mesh;
  mesh.mesh = test.cook(desc);
  mesh.pose.translate = {0, -0.3, -2};
  mesh.velocity = {0, 0.3, 0};
  mesh.friction = 0.2;
  test.take(test.world().create_mesh(mesh));
}

inline void add_colliders(TestWorld& test) {
  weft::SphereDesc sphere;
  sphere.center = {0.5, 0.1, -1.2};
  sphere.radius = 0.5;
  sphere.velocity = {0.1, 0.5, 0};
  test.take(test.world().create_sphere(sphere));
  weft::PlaneDesc plane;
  plane.normal = {0.1, 1, 0.2};
  plane.offset = -0.1;
  plane.velocity = {0, 0.2, 0};
  plane.friction = 0.3;
  test.take(test.world().create_plane(plane));
  weft::BoxDesc box;
  box.center = {2.5, -0.2, -1.3};
  box.half = {0.4, 0.3, 0.5};
  box.friction = 0.4;
  const weft::ColliderId turning = test.take(test.world().create_box(box));
  weft::Pose pose;
  pose.axis = {0, 1, 0.2};
  pose.degrees = 20;
  pose.translate = {0.3, 0.4, 0};
  test.check(test.world().move_collider(turning, pose));
  add_wavy_collider(test);
}

inline void add_wind(TestWorld& test) {
  weft::WindDesc wind;
  wind.velocity = {3, 0.5, 2};
  test.check(test.world().set_wind(wind));
}

inline void add_cloths(TestWorld& test, Scene scene) {
  if (scene == Scene::grids || scene == Scene::mixed) add_grids(test, 21, 35);
  if (scene == Scene::mesh || scene == Scene::mixed) add_mesh(test, 35);
  if (scene == Scene::network || scene == Scene::mixed) add_graph(test, 1100);
}

/// More than a thousand particles: enough that a step uses every thread.
inline void add_scene(TestWorld& test, Scene scene) {
  add_colliders(test);
  if (scene == Scene::mesh || scene == Scene::mixed) add_wind(test);
  add_cloths(test, scene);
}

inline weft::WorldDesc scene_world(Variant variant) {
  weft::WorldDesc desc;
  desc.precision = variant.precision;
  desc.form = variant.form;
  return desc;
}

/// A quarter of a second in frames of 1/60 s with automatic substeps.
inline void run_scene(TestWorld& test) { test.step(1.0 / 60, 15); }

}  // namespace weft_tests
