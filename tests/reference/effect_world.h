// A world with a cloth of every kind for the rows of the table of effects. Its input is made with
// + - * / and square roots only, so that every compiler makes the same.
#pragma once

#include "reference/grid.h"
#include "reference/random.h"
#include "samples/effects/effects.h"

namespace weft_tests {

using weft::samples::Change;
using weft::samples::Changes;
using weft::samples::Effect;

/// A grid, a crumpled mesh and a network at the unit square of z = 0, more than a thousand
/// particles, hung from two vertices each unless a row pins others.
class EffectWorld {
 public:
  EffectWorld(weft::Context& context, weft::WorldDesc desc, Changes changes)
      : changes_(std::move(changes)), world_(made(context, desc, changes_)) {
    stage_ = std::make_unique<weft::samples::Stage>(
        weft::samples::Stage{context, world_, {}, {}, false});
    add_grid();
    add_mesh();
    add_network();
    weft::samples::furnish(changes_, *stage_);
  }

  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      weft::samples::lead(changes_, *stage_, ++frame_);
      weft::samples::check(world_.step(1.0 / 60));
    }
  }
  weft::World& world() { return world_; }
  const std::vector<weft::ClothId>& cloths() const { return stage_->cloths; }
  uint64_t hash() { return weft::samples::take(world_.state_hash()); }

 private:
  static weft::World made(weft::Context& context, weft::WorldDesc desc, const Changes& changes) {
    desc.gravity = weft::samples::down;
    weft::samples::begin(changes, desc);
    return weft::samples::take(context.create_world(desc));
  }
  template <class Desc>
  void add(const Desc& fabric) {
    weft::ClothDesc cloth;
    cloth.fabric = weft::samples::take(stage_->context.cook(fabric));
    weft::samples::hang(cloth);
    weft::samples::dress(changes_, cloth);
    stage_->cloths.push_back(weft::samples::take(world_.create_cloth(cloth)));
  }

  void add_grid() {
    weft::GridDesc grid;
    grid.rows = 33;
    grid.columns = 47;
    grid.material.stiffness = 60;
    add(grid);
  }
  void add_mesh() {
    constexpr uint32_t n = 21;
    reference::SplitMix random(21);
    std::vector<weft::double3> x;
    for (const reference::Vec p : reference::grid_positions(n, n)) {
      const reference::Vec q = p + random.noise(0.2 / n);
      x.push_back({q.x, q.y, 0.1 + q.z});
    }
    std::vector<uint32_t> indices;
    for (uint32_t v = 0; v < (n - 1) * n; ++v) {
      if (v % n == n - 1) continue;
      indices.insert(indices.end(), {v, v + 1, v + n + 1, v, v + n + 1, v + n});
    }
    weft::MeshDesc mesh;
    mesh.positions = weft::View<weft::double3>(x);
    mesh.indices = indices;
    mesh.bend = true;
    mesh.material.stiffness = {60, 0, 5};
    mesh.material.mass.kind = weft::Mass::Kind::density;
    mesh.material.mass.value = 0.3;
    add(mesh);
  }
  void add_network() {
    reference::SplitMix random(4);
    std::vector<weft::double3> x;
    std::vector<weft::Spring> springs;
    for (uint32_t i = 0; i < 300; ++i) {
      const reference::Vec p = random.noise(0.5) + reference::Vec{0.5, 0.5, 0.5};
      x.push_back({p.x, p.y, 0.2 * p.z});
      for (uint32_t k = 1; k < 4 && i > k; ++k) springs.push_back({i, i - k, 5, -1});
    }
    weft::NetworkDesc network;
    network.positions = weft::View<weft::double3>(x);
    network.springs = springs;
    add(network);
  }

  Changes changes_;
  weft::World world_;
  std::unique_ptr<weft::samples::Stage> stage_;
  int frame_ = 0;
};

}  // namespace weft_tests
