#include "bench/stretch_scenes.h"

#include <algorithm>
#include <cmath>

#include "samples/effects/effect.h"

namespace weft::bench {

namespace {

using samples::check;
using samples::take;

constexpr double frame_seconds = 1.0 / 60;
constexpr uint32_t cape_rows = 20, cape_columns = 18, capes = 100;

ContextDesc context_of(uint32_t threads) {
  ContextDesc desc;
  desc.backend = BackendKind::omp;
  desc.threads = threads;
  return desc;
}

WorldDesc world_of(const Method& method) {
  WorldDesc desc;
  desc.integrator = method.integrator;
  desc.substeps = method.substeps;
  std::fill(std::begin(desc.ladder), std::end(desc.ladder), uint8_t(0));
  std::copy(method.ladder.begin(), method.ladder.end(), desc.ladder);
  return desc;
}

double distance(const double3& a, const double3& b) {
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

}  // namespace

const char* to_string(StretchScene scene) {
  switch (scene) {
    case StretchScene::edge:
      return "edge";
    case StretchScene::pin:
      return "pin";
    case StretchScene::sphere:
      return "sphere";
    case StretchScene::capes:
      return "capes";
  }
  return "";
}

struct StretchRun::Parts {
  Parts(StretchScene scene, uint32_t n, const Method& method, uint32_t threads)
      : context(take(Context::create(context_of(threads)))),
        world(take(context.create_world(world_of(method)))),
        rows(scene == StretchScene::capes ? cape_rows : n),
        columns(scene == StretchScene::capes ? cape_columns : n) {
    single = threads == 1;
    if (scene == StretchScene::capes) {
      hang_capes(method);
    } else {
      add_sheet(scene, method);
    }
  }

  void add_sheet(StretchScene scene, const Method& method) {
    GridDesc grid;
    grid.rows = rows;
    grid.columns = columns;
    grid.width = grid.height = 2;
    grid.stencil = Stencil::classic12;
    grid.material.stiffness = method.stiffness;
    grid.material.mass.value = 1;
    mass = 1.0 / (double(rows) * columns);
    spacing = {2.0 / (columns - 1), 2.0 / (rows - 1)};
    std::vector<Pin> pins;
    if (scene == StretchScene::edge) {
      for (uint32_t c = 0; c < columns; ++c) pins.push_back({c});
    } else if (scene == StretchScene::pin) {
      pins = {{0}, {columns - 1}, {columns * (rows - 1)}, {columns * rows - 1}};
    } else {
      SphereDesc sphere{{1, -0.6, 1}, 0.5};
      sphere.friction = 0.3;
      check(world.create_sphere(sphere).status());
    }
    ClothDesc cloth;
    cloth.fabric = take(context.cook(grid));
    cloth.pose = {{1, 0, 0}, 90, {0, 0, 0}};  // in the plane y = 0
    cloth.pins = pins;
    cloth.drag = 0.1 * mass;  // 0.1/s
    if (method.tethered) cloth.tether_scale = 1;
    cloths.push_back(take(world.create_cloth(cloth)));
  }

  void hang_capes(const Method& method) {
    GridDesc grid;
    grid.rows = rows;
    grid.columns = columns;
    grid.width = 0.85;
    grid.height = 0.95;
    grid.stencil = Stencil::classic12;
    grid.material.stiffness = method.stiffness;
    grid.material.mass.value = 0.3;
    mass = 0.3 / (double(rows) * columns);
    spacing = {grid.width / (columns - 1), grid.height / (rows - 1)};
    std::vector<Pin> pins;
    for (uint32_t c = 0; c < columns; ++c) pins.push_back({(rows - 1) * columns + c});
    ClothDesc cloth;
    cloth.fabric = take(context.cook(grid));
    cloth.pins = pins;
    cloth.drag = 0.1 * mass;
    if (method.tethered) cloth.tether_scale = 1;
    for (uint32_t k = 0; k < capes; ++k) {
      // Swung out, so that it falls back to the body.
      cloth.pose = {{1, 0, 0}, 40, {2.0 * (k % 10), 0, 3.0 * (k / 10)}};
      cloth.collision_layers = cape_layer(k);
      cloths.push_back(take(world.create_cloth(cloth)));
    }
    bodies = take(world.create_collider_set(capsules(0)));
  }
  static uint32_t cape_layer(uint32_t k) { return 1u << (k % 32); }
  CapsuleDesc capsule(uint32_t cape, int which, double time) const {
    const double sway = 0.1 * std::sin(5 * time + cape);
    const double x = 2.0 * (cape % 10) + 0.2 + 0.22 * which + sway;
    const double z = 3.0 * (cape / 10) + 0.8;
    CapsuleDesc desc{{x, -0.2, z}, {x, 0.6, z}, 0.12};
    desc.friction = 0.2;
    desc.layers = cape_layer(cape);
    return desc;
  }

  ColliderSetDesc capsules(double time) {
    placed.clear();
    for (uint32_t k = 0; k < capes; ++k) {
      for (int c = 0; c < 3; ++c) placed.push_back(capsule(k, c, time));
    }
    ColliderSetDesc set;
    set.capsules = placed;
    return set;
  }

  void lead() {
    ++frames;
    if (bodies) check(world.move_collider_set(bodies, capsules(frames * frame_seconds)));
  }

  std::vector<double3> positions(ClothId id) const {
    std::vector<double3> x(size_t(rows) * columns);
    check(const_cast<World&>(world).read_positions(id, x.data()));
    return x;
  }

  Context context;
  World world;
  uint32_t rows, columns;
  bool single = true;
  double mass = 0;  ///< kg, of a vertex
  struct {
    double column, row;
  } spacing{};
  std::vector<ClothId> cloths;
  ColliderSetId bodies;
  std::vector<CapsuleDesc> placed;
  int frames = 0;
};

StretchRun::StretchRun(StretchScene scene, uint32_t n, const Method& method, uint32_t threads)
    : parts_(std::make_unique<Parts>(scene, n, method, threads)) {
  check(parts_->world.prepare(frame_seconds));
}
StretchRun::~StretchRun() = default;

double StretchRun::frame() {
  parts_->lead();
  const auto seconds = [&] {
    const Stats s = parts_->world.stats();
    return parts_->single ? s.cpu_seconds : s.step_seconds;
  };
  const double before = seconds();
  check(parts_->world.step(frame_seconds));
  return seconds() - before;
}

Stretched StretchRun::stretch() const {
  std::vector<double> all;
  for (const ClothId id : parts_->cloths) {
    const std::vector<double3> x = parts_->positions(id);
    for (uint32_t r = 0; r < parts_->rows; ++r) {
      for (uint32_t c = 0; c < parts_->columns; ++c) {
        const size_t i = size_t(r) * parts_->columns + c;
        if (c + 1 < parts_->columns) {
          all.push_back(distance(x[i], x[i + 1]) / parts_->spacing.column - 1);
        }
        if (r + 1 < parts_->rows) {
          all.push_back(distance(x[i], x[i + parts_->columns]) / parts_->spacing.row - 1);
        }
      }
    }
  }
  const auto at = all.begin() + static_cast<ptrdiff_t>(0.99 * double(all.size()));
  std::nth_element(all.begin(), at, all.end());
  return {*at, *std::max_element(at, all.end())};
}

Energies StretchRun::energies() const {
  const Mechanics m = take(parts_->world.mechanics());
  double sum = 0;
  size_t count = 0;
  for (const ClothId id : parts_->cloths) {
    for (const double3& x : parts_->positions(id)) sum += x.y;
    count += size_t(parts_->rows) * parts_->columns;
  }
  return {sum / double(count), m.kinetic, m.potential};
}

uint32_t StretchRun::substeps() const { return parts_->world.stats().substeps_last; }

}  // namespace weft::bench
