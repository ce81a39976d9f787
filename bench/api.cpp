#include "bench/api.h"

#include <cstring>
#include <memory>

#include "bench/interleave.h"
#include "bench/sheets.h"

namespace weft::bench {

namespace {

Candidate stepped(const std::string& name, uint32_t n, uint32_t cloths, int substeps,
                  double units = 0) {
  SteppedWorld::Options options;
  options.cloths = cloths;
  options.substeps = substeps;
  auto world = std::make_shared<SteppedWorld>(SteppedWorld::sheet(n, Stencil::seed12, options));
  return {name, units > 0 ? units : world->particle_steps(), [world] { world->advance(); }};
}

/// A step of one particle is nothing but the interface's own work.
void bench_calls(int rounds, std::ostream& progress, std::vector<Row>& rows) {
  Interleaved runs("api");
  SteppedWorld::Options options;
  options.substeps = 1;
  auto one = std::make_shared<SteppedWorld>(SteppedWorld::sheet(1, Stencil::seed12, options));
  const size_t call = runs.add({"a step of one particle", 1000, [one] {
                                  for (int i = 0; i < 1000; ++i) one->advance();
                                }});
  const size_t sheet = runs.add(stepped("a step of 256x256, 8 substeps", 256, 1, 8, 1));
  runs.run(rounds, progress);
  runs.append_times("ns_per_call", "ns", rows);
  runs.append_ratio("one particle / 256x256", call, sheet, rows);
}

void bench_cloths(int rounds, std::ostream& progress, std::vector<Row>& rows) {
  Interleaved runs("api");
  const size_t one = runs.add(stepped("1 cloth of 128x128", 128, 1, 32));
  const size_t some = runs.add(stepped("64 cloths of 16x16", 16, 64, 32));
  const size_t large = runs.add(stepped("1 cloth of 253x253", 253, 1, 8));
  const size_t many = runs.add(stepped("1000 cloths of 8x8", 8, 1000, 8));
  runs.run(rounds, progress);
  runs.append_times("ns_per_particle_step", "ns", rows);
  runs.append_ratio("64 cloths of 16x16 / 1 of 128x128", some, one, rows);
  runs.append_ratio("1000 cloths of 8x8 / 1 of 253x253", many, large, rows);
}

/// Position and normal, 24 bytes a vertex, against a copy of as many bytes.
void bench_outputs(int rounds, std::ostream& progress, std::vector<Row>& rows) {
  constexpr uint32_t n = 256;
  struct Buffers {
    std::vector<float> from = std::vector<float>(6 * n * n, 1.0f);
    std::vector<float> to = std::vector<float>(6 * n * n);
  };
  auto buffers = std::make_shared<Buffers>();
  const size_t bytes = buffers->to.size() * sizeof(float);
  auto world = std::make_shared<SteppedWorld>(SteppedWorld::sheet(n, Stencil::seed12, {}));
  OutputDesc desc;
  desc.layout.position = {Format::f32x3, 0, 24};
  desc.layout.normal = {Format::f32x3, 12, 24};
  desc.memory = buffers->to.data();
  desc.bytes = bytes;
  (void)world->world().bind_output(world->cloth(), desc);

  Interleaved runs("api");
  constexpr int calls = 20;
  const size_t copy = runs.add({"memcpy of 24 B per vertex", double(calls) * n * n, [=] {
                                  for (int i = 0; i < calls; ++i) {
                                    buffers->from[size_t(i)] = float(i);
                                    std::memcpy(buffers->to.data(), buffers->from.data(), bytes);
                                  }
                                }});
  const size_t write = runs.add({"write-out of position and normal", double(calls) * n * n, [=] {
                                   for (int i = 0; i < calls; ++i) {
                                     (void)world->world().write_outputs();
                                   }
                                 }});
  // Another gravity makes the normals stale.
  auto turn = std::make_shared<int>(0);
  runs.add({"the same, the pass that makes the normals included", double(calls) * n * n, [=] {
              for (int i = 0; i < calls; ++i) {
                (void)world->world().set_gravity({0, -9 - double(++*turn % 2), 0});
                (void)world->world().write_outputs();
              }
            }});
  runs.run(rounds, progress);
  runs.append_times("ns_per_vertex", "ns", rows);
  runs.append_ratio("memcpy / write-out: its share of memcpy's speed", copy, write, rows);
}

}  // namespace

std::vector<Row> run_api(bool quick, std::ostream& progress) {
  std::vector<Row> rows;
  const int rounds = quick ? 7 : 31;
  bench_calls(rounds, progress, rows);
  bench_cloths(rounds, progress, rows);
  bench_outputs(rounds, progress, rows);
  return rows;
}

}  // namespace weft::bench
