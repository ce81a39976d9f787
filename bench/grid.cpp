#include "bench/grid.h"

#include <cmath>
#include <cstring>
#include <memory>

#include "bench/chapter_loop.h"
#include "bench/floor.h"
#include "bench/interleave.h"
#include "bench/sheets.h"

namespace weft::bench {

namespace {

constexpr const char* metric = "ns_per_particle_step";

std::string size_name(uint32_t n) { return std::to_string(n) + "x" + std::to_string(n); }

Candidate weft_candidate(const std::string& name, uint32_t n,
                         const SteppedWorld::Options& options) {
  auto world = std::make_shared<SteppedWorld>(SteppedWorld::sheet(n, Stencil::seed12, options));
  return {name, world->particle_steps(), [world] { world->advance(); }};
}

template <class Step>
Candidate chapter_candidate(const std::string& name, uint32_t n, Step step) {
  const float m = 1.0f / float(n * n);
  auto sheet = std::make_shared<ChapterSheet>(
      make_chapter_sheet(int(n), 100, m, 0.9f * 0.4082f * std::sqrt(m / 100)));
  return {name, double(n) * n * 2, [sheet, step] {
            step(*sheet);
            step(*sheet);
          }};
}

template <class T>
Candidate floor_candidate(const std::string& name, const char* isa) {
  auto data = std::make_shared<std::vector<T>>(64 * 64, T(1.5));
  constexpr int rounds = 12 * 16;
  return {name, double(data->size()) * rounds / 12,
          [data, isa] { roots_and_divisions(isa, data->data(), data->size(), rounds); }};
}

const char* isa_of_this_machine() {
  ContextDesc desc;
  desc.backend = BackendKind::omp;
  const auto context = Context::create(desc);
  return context ? (*context).info().isa : "v2";
}

/// The chapter's size, every comparison that the numbers of this project are judged by.
void bench_256(int rounds, std::ostream& progress, std::vector<Row>& rows) {
  const char* isa = isa_of_this_machine();
  Interleaved runs("grid");
  const size_t plain =
      runs.add(chapter_candidate("256x256 chapter loop, -O3", 256, plain::chapter_step));
  const size_t safe = runs.add(
      chapter_candidate("256x256 chapter loop, bit-safe flags", 256, bit_safe::chapter_step));
  const size_t one = runs.add(weft_candidate("256x256 weft float32, 1 thread", 256, {}));
  SteppedWorld::Options options;
  options.threads = 2;
  const size_t two = runs.add(weft_candidate("256x256 weft float32, 2 threads", 256, options));
  options.threads = 1;
  options.precision = Precision::float64;
  const size_t wide = runs.add(weft_candidate("256x256 weft float64, 1 thread", 256, options));
  const size_t floor = runs.add(floor_candidate<float>("12 roots and divisions, float32", isa));
  const size_t wide_floor =
      runs.add(floor_candidate<double>("12 roots and divisions, float64", isa));
  size_t safe_v4 = 0;
  if (std::strcmp(isa, "v4") == 0) {
    safe_v4 = runs.add(chapter_candidate("256x256 chapter loop, bit-safe flags and x86-64-v4", 256,
                                         bit_safe_v4::chapter_step));
  }
  runs.run(rounds, progress);
  runs.append_times(metric, "ns", rows);
  runs.append_ratio("256x256 chapter -O3 / weft", plain, one, rows);
  runs.append_ratio("256x256 chapter bit-safe / weft", safe, one, rows);
  if (safe_v4 > 0) runs.append_ratio("256x256 chapter bit-safe v4 / weft", safe_v4, one, rows);
  runs.append_ratio("256x256 1 thread / 2 threads", one, two, rows);
  runs.append_ratio("256x256 float64 / float32", wide, one, rows);
  runs.append_ratio("256x256 float32 / floor", one, floor, rows);
  runs.append_ratio("256x256 float64 / floor", wide, wide_floor, rows);
}

/// The chapter's figure 22.5, and on to 2048 squared: its loop beside weft.
void bench_sizes(bool quick, std::ostream& progress, std::vector<Row>& rows) {
  Interleaved runs("grid");
  size_t index_256 = 0, index_2048 = 0;
  for (const uint32_t n : {32u, 64u, 128u, 256u, 512u, 1024u, 2048u}) {
    SteppedWorld::Options options;
    options.substeps = n <= 128 ? int(65536 * 8 / (n * n)) : n >= 1024 ? 2 : steps_per_call;
    const size_t i =
        runs.add(weft_candidate(size_name(n) + " weft float32, 1 thread, by size", n, options));
    if (n == 256) index_256 = i;
    if (n == 2048) index_2048 = i;
    if (quick && n > 512) continue;
    runs.add(
        chapter_candidate(size_name(n) + " chapter loop, -O3, by size", n, plain::chapter_step));
    runs.add(chapter_candidate(size_name(n) + " chapter loop, bit-safe flags, by size", n,
                               bit_safe::chapter_step));
  }
  runs.run(quick ? 3 : 9, progress);
  runs.append_times(metric, "ns", rows);
  runs.append_ratio("2048x2048 / 256x256 per particle", index_2048, index_256, rows);
}

}  // namespace

ChapterSheet make_chapter_sheet(int n, float k, float m, float dt) {
  ChapterSheet s;
  s.n = n;
  s.k = k;
  s.m = m;
  s.dt = dt;
  for (int i = 0; i < n * n; ++i) {
    s.now.push_back({float(i % n) / float(n - 1), float(i / n) / float(n - 1), 0, 1});
  }
  s.before = s.next = s.now;
  return s;
}

std::vector<Row> run_grid(bool quick, std::ostream& progress) {
  std::vector<Row> rows;
  bench_256(quick ? 9 : 31, progress, rows);
  bench_sizes(quick, progress, rows);
  return rows;
}

}  // namespace weft::bench
