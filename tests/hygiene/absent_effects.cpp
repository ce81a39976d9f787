// A 64 x 64 sheet without any optional effect, for counting the instructions of its steps.
// usage: PROGRAM FRAMES   prints the bytes of its state
#include <cstdio>
#include <cstdlib>

#include "weft/weft.hpp"

int main(int count, char** argument) {
  const int frames = count > 1 ? std::atoi(argument[1]) : 1;
  weft::ContextDesc desc;
  desc.backend = weft::BackendKind::omp;
  desc.isa = weft::Isa::v2;
  desc.threads = 1;
  auto context = weft::Context::create(desc);
  if (!context) return 1;
  weft::WorldDesc world_desc;
  world_desc.substeps = 16;
  auto world = context->create_world(world_desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = 64;
  auto fabric = context->cook(grid);
  if (!world || !fabric) return 1;
  weft::ClothDesc cloth;
  cloth.fabric = *fabric;
  if (!world->create_cloth(cloth)) return 1;
  const double dt = 0.9 * 16 * world->stability().dt_bound;
  for (int frame = 0; frame < frames; ++frame) {
    if (world->step(dt) != weft::Status::ok) return 1;
  }
  std::printf("%llu\n", static_cast<unsigned long long>(world->stats().bytes_state));
  return 0;
}
