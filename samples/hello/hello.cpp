// A level sheet held by two corners falls and swings for a second: a small whole program with weft.
#include "weft/weft.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

void print(void*, weft::Severity, const char* text) { std::fprintf(stderr, "weft: %s\n", text); }

// Says what did not work (the reason was logged already) and gives the exit code of main.
int failed(const char* what, weft::Status status) {
  std::fprintf(stderr, "hello: %s failed: %s\n", what, weft::to_string(status));
  return 1;
}

}  // namespace

int main() {
  weft::ContextDesc context_desc;
  context_desc.log.message = print;
  auto context = weft::Context::create(context_desc);
  if (!context) return failed("making a context", context.status());

  // One square metre of 64 x 64 particles, 200 g. Cooked once, used by any number of cloths.
  weft::GridDesc grid;
  grid.rows = grid.columns = 64;
  grid.material.stiffness = weft::Stiffness(50.0);
  grid.material.mass.value = 0.2;
  auto fabric = context->cook(grid);
  if (!fabric) return failed("cooking the fabric", fabric.status());

  auto world = context->create_world();
  if (!world) return failed("making a world", world.status());

  // Turned by 90 degrees the sheet starts level; the corners of its last row are held.
  const std::vector<weft::Pin> pins = {{63 * 64}, {63 * 64 + 63}};
  weft::ClothDesc cloth_desc;
  cloth_desc.fabric = *fabric;
  cloth_desc.pose.degrees = 90;
  cloth_desc.pins = pins;
  cloth_desc.drag = 1e-5;
  const auto cloth = world->create_cloth(cloth_desc);
  if (!cloth) return failed("making the cloth", cloth.status());

  for (int frame = 0; frame < 60; ++frame) {
    const weft::Status status = world->step(1.0 / 60);
    if (status != weft::Status::ok) return failed("a step", status);
  }

  std::vector<weft::float3> points(fabric->vertex_count());
  const weft::Status status = world->read_positions(*cloth, points.data());
  if (status != weft::Status::ok) return failed("reading the positions", status);
  const auto lowest = std::min_element(points.begin(), points.end(),
                                       [](auto a, auto b) { return a.y < b.y; });
  const weft::Stats stats = world->stats();
  const double updates = double(stats.particles) * double(stats.steps);
  std::printf("lowest point after %.3f s: (%.3f, %.3f, %.3f) m\n", world->time(), lowest->x,
              lowest->y, lowest->z);
  std::printf("%u particles, %u substeps per frame, %.2f ns per particle and substep\n",
              fabric->vertex_count(), stats.substeps_last, stats.step_seconds / updates * 1e9);
  return 0;
}
