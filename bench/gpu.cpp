#include "bench/gpu.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>

#include "bench/interleave.h"
#include "bench/irregular.h"
#include "bench/sheets.h"

namespace weft::bench {

namespace {

constexpr int frame = 16;        // substeps of a game's frame
constexpr int long_frame = 512;  // so long that what a frame costs besides does not count

struct Case {
  std::string name;
  uint32_t n;
  SteppedWorld::Options options;
};

SteppedWorld::Options on_gpu(BackendKind gpu, int substeps) {
  SteppedWorld::Options options;
  options.backend = gpu;
  options.substeps = substeps;
  return options;
}

std::string size_name(uint32_t n) { return std::to_string(n) + "x" + std::to_string(n); }

/// Time per substep of a frame in us, and what fraction of the copy's bandwidth it moves.
void measure(const std::vector<Case>& cases, int rounds, double bandwidth, std::ostream& progress,
             std::vector<Row>& rows) {
  for (const Case& c : cases) {
    Interleaved runs("gpu");
    SteppedWorld world = SteppedWorld::sheet(c.n, Stencil::seed12, c.options);
    runs.add({c.name, double(c.options.substeps) * 1e3, [&world] { world.advance(); }});
    runs.run(rounds, progress);
    const size_t first = rows.size();
    runs.append_times("us_per_substep", "us", rows);
    Row row = rows[first];
    const double steps = world.particle_steps() / c.options.substeps;
    row.metric = "ns_per_particle_step";
    row.unit = "ns";
    for (double* t : {&row.median, &row.min, &row.max}) *t *= 1e3 / steps;
    rows.push_back(row);
    if (bandwidth <= 0 || steps < 1e6) continue;  // below, a sheet lives in the caches
    row = rows[first];
    row.metric = "of_copy_bandwidth";
    row.unit = "1";
    const double bytes = world.bytes_per_step();
    row.median = bytes / (rows[first].median * 1e-6) / bandwidth;
    row.min = bytes / (rows[first].max * 1e-6) / bandwidth;
    row.max = bytes / (rows[first].min * 1e-6) / bandwidth;
    rows.push_back(row);
  }
}

std::vector<Case> cases(BackendKind gpu, bool quick) {
  std::vector<Case> all;
  const auto add = [&](const std::string& name, uint32_t n, int substeps,
                       const std::function<void(SteppedWorld::Options&)>& change = {}) {
    SteppedWorld::Options options = on_gpu(gpu, substeps);
    if (change) change(options);
    all.push_back({name, n, options});
  };
  const auto wide = [](SteppedWorld::Options& o) { o.precision = Precision::float64; };
  add("8x8 float32, long frame: a launch", 8, long_frame);
  for (const uint32_t n : {64u, 256u, 512u, 1024u, 2048u, 4096u}) {
    if (quick && n > 1024) break;
    add(size_name(n) + " float32, frame of 16", n, frame);
  }
  for (const uint32_t n : {64u, 256u, 512u, 1024u}) {
    add(size_name(n) + " float32, long frame", n, long_frame);
  }
  for (const uint32_t n : {256u, 1024u, 4096u}) {
    if (quick && n > 1024) break;
    add(size_name(n) + " float64, frame of 16", n, frame, wide);
  }
  add("1000 cloths of 8x8 float32, frame of 16", 8, frame,
      [](SteppedWorld::Options& o) { o.cloths = 1000; });
  add("1024 cloths of 32x32 float32, frame of 16", 32, frame,
      [](SteppedWorld::Options& o) { o.cloths = 1024; });
  add("1024x1024 float32 with a sphere and a plane", 1024, frame, [](SteppedWorld::Options& o) {
    o.furnish = [](Context&, World& world, ClothId) {
      (void)world.set_gravity({0, 0, -9.81});
      SphereDesc sphere;
      sphere.center = {0.5, 0.5, -0.3};
      sphere.radius = 0.3;
      (void)world.create_sphere(sphere);
      PlaneDesc plane;
      plane.normal = {0, 0, 1};
      plane.offset = -0.01;
      (void)world.create_plane(plane);
    };
  });
  add("1024x1024 float32 in wind", 1024, frame, [](SteppedWorld::Options& o) {
    o.furnish = [](Context&, World& world, ClothId) {
      WindDesc wind;
      wind.velocity = {0, 0, 5};
      (void)world.set_wind(wind);
    };
  });
  return all;
}

/// The host of the same machine, all of its threads, for the ratio.
void measure_host(int rounds, std::ostream& progress, std::vector<Row>& rows) {
  std::vector<Case> all;
  for (const uint32_t n : {256u, 1024u}) {
    SteppedWorld::Options options;
    options.threads = 0;
    options.substeps = frame;
    all.push_back({size_name(n) + " float32, host, all threads", n, options});
  }
  measure(all, rounds, 0, progress, rows);
}

/// Gather against scatter, and an irregular mesh against the regular one of as many edges.
void measure_meshes(BackendKind gpu, bool quick, int rounds, std::ostream& progress,
                    std::vector<Row>& rows) {
  const uint32_t n = quick ? 256 : 1024;
  const TriangleSheet regular = triangle_sheet(n), irregular = irregular_sheet(n, false);
  Interleaved runs("gpu");
  const auto add = [&](const std::string& name, const TriangleSheet& sheet, Evaluation evaluation,
                       Accumulate accumulate) {
    SteppedWorld::Options options = on_gpu(gpu, frame);
    options.evaluation = evaluation;
    options.accumulate = accumulate;
    auto world = std::make_shared<SteppedWorld>(
        SteppedWorld::mesh(sheet.positions, sheet.triangles, options));
    return runs.add(
        {size_name(n) + " " + name, world->edge_steps(), [world] { world->advance(); }});
  };
  const size_t gather = add("mesh, gather", regular, Evaluation::gather, Accumulate::native);
  const size_t uneven =
      add("irregular mesh, gather", irregular, Evaluation::gather, Accumulate::native);
  std::vector<size_t> scatters;
  for (const Accumulate a : {Accumulate::native, Accumulate::atomic, Accumulate::fixed64}) {
    scatters.push_back(
        add(std::string("mesh, scatter ") + to_string(a), regular, Evaluation::scatter, a));
  }
  runs.run(rounds, progress);
  runs.append_times("ns_per_edge", "ns", rows);
  for (const size_t s : scatters) {
    runs.append_ratio(runs.name(s) + " / gather", s, gather, rows);
  }
  runs.append_ratio(size_name(n) + " irregular / regular, gather", uneven, gather, rows);
}

/// cuda or hip; automatic where there is neither.
BackendKind gpu_here(std::ostream& progress) {
  const auto context = Context::create();
  const ContextInfo info = context ? context->info() : ContextInfo{};
  const std::string name = context ? info.backend : "";
  if (name == "cuda") return BackendKind::cuda;
  if (name == "hip") return BackendKind::hip;
  progress << "gpu: nothing to measure ("
           << (context && info.fallback ? info.fallback : "this build has no GPU back end")
           << ")\n";
  return BackendKind::automatic;
}

}  // namespace

std::vector<Row> run_gpu(bool quick, std::ostream& progress) {
  std::vector<Row> rows;
  const BackendKind gpu = gpu_here(progress);
  if (gpu == BackendKind::automatic) return rows;
  const double bandwidth = gpu_copy_bandwidth();
  if (bandwidth > 0) {
    const double gb = bandwidth * 1e-9;
    rows.push_back(
        {"gpu", "copy on the device, bytes read and written", "bandwidth", "GB/s", gb, gb, gb, 1});
  }
  const int rounds = quick ? 5 : 21;
  measure(cases(gpu, quick), rounds, bandwidth, progress, rows);
  measure_meshes(gpu, quick, rounds, progress, rows);
  measure_host(rounds, progress, rows);
  return rows;
}

#if !defined(WEFT_HAVE_GPU_FLOOR)
double gpu_copy_bandwidth() { return 0; }
#endif

}  // namespace weft::bench
