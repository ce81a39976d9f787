// A user's program: the public interface end to end, without exceptions and RTTI. Prints the hash
// of the state, which is the same however weft was linked.
#include "weft/weft.hpp"

#include <cstdio>

namespace {

int failed(const char* what, weft::Status status) {
  std::fprintf(stderr, "%s: %s\n", what, weft::to_string(status));
  return 1;
}

}  // namespace

extern "C" int run_consumer() {
  weft::ContextDesc context_desc;
  context_desc.threads = 1;
  auto context = weft::Context::create(context_desc);
  if (!context) return failed("create", context.status());

  weft::GridDesc grid;
  grid.rows = grid.columns = 20;
  auto fabric = context->cook(grid);
  if (!fabric) return failed("cook", fabric.status());

  auto world = context->create_world();
  if (!world) return failed("create_world", world.status());
  const weft::Pin pins[] = {{0}, {19}};
  weft::ClothDesc cloth_desc;
  cloth_desc.fabric = *fabric;
  cloth_desc.pins = {pins, 2};
  auto cloth = world->create_cloth(cloth_desc);
  if (!cloth) return failed("create_cloth", cloth.status());
  weft::SphereDesc sphere;
  sphere.center = {0.5, -0.6, 0};
  sphere.radius = 0.3;
  auto collider = world->create_sphere(sphere);
  if (!collider) return failed("create_sphere", collider.status());

  for (int i = 0; i < 30; ++i) {
    const weft::Status status = world->step(1.0 / 60);
    if (status != weft::Status::ok) return failed("step", status);
  }
  weft::float3 positions[400];
  const weft::Status read = world->read_positions(*cloth, positions);
  if (read != weft::Status::ok) return failed("read_positions", read);
  if (!(positions[399].y < 0.9f)) return failed("the sheet did not fall", weft::Status::diverged);
  auto hash = world->state_hash();
  if (!hash) return failed("state_hash", hash.status());
  std::printf("%016llx\n", static_cast<unsigned long long>(*hash));
  return 0;
}

#ifndef WEFT_PLUGIN
int main() { return run_consumer(); }
#endif
