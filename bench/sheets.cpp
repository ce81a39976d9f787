#include "bench/sheets.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace weft::bench {

namespace {

template <class T>
T take(Result<T> result, const char* what) {
  if (!result) throw std::runtime_error(std::string(what) + ": " + to_string(result.status()));
  return std::move(*result);
}

Context make_context(const SteppedWorld::Options& options) {
  ContextDesc desc;
  desc.backend = options.backend;
  desc.threads = options.threads;
  return take(Context::create(desc), "context");
}

}  // namespace

SteppedWorld::SteppedWorld(Context context, Fabric fabric, const Options& options)
    : context_(std::move(context)), substeps_(options.substeps) {
  WorldDesc desc;
  desc.precision = options.precision;
  desc.substeps = static_cast<uint32_t>(substeps_);
  desc.evaluation = options.evaluation;
  desc.accumulate = options.accumulate;
  desc.deterministic = options.accumulate != Accumulate::atomic;
  desc.profile = options.profile;
  if (options.begin) options.begin(desc);
  world_ = take(context_.create_world(desc), "world");
  ClothDesc cloth;
  cloth.fabric = fabric;
  if (options.dress) options.dress(cloth);
  cloth_ = take(world_.create_cloth(cloth), "cloth");
  if (options.furnish) options.furnish(context_, world_, cloth_);
  for (uint32_t i = 1; i < options.cloths; ++i) take(world_.create_cloth(cloth), "cloth");
  particles_ = uint64_t(options.cloths) * fabric.vertex_count();
  directed_springs_ = uint64_t(options.cloths) * 2 * fabric.spring_count();
  const double bound = world_.stability().dt_bound;
  dt_ = substeps_ * (std::isfinite(bound) ? 0.9 * bound : 1e-3);  // nothing bounds a lone particle
  advance();
}

SteppedWorld SteppedWorld::sheet(uint32_t n, Stencil stencil, const Options& options) {
  Context context = make_context(options);
  GridDesc desc;
  desc.rows = desc.columns = n;
  desc.stencil = stencil;
  desc.material.stiffness = options.stiffness;
  Fabric fabric = take(context.cook(desc), "grid");
  return {std::move(context), fabric, options};
}

SteppedWorld SteppedWorld::particles(uint32_t count, const Options& options) {
  return network(std::vector<double3>(count, double3{0, 0, 0}), {}, options);
}

SteppedWorld SteppedWorld::network(const std::vector<double3>& positions,
                                   const std::vector<Spring>& springs, const Options& options) {
  Context context = make_context(options);
  NetworkDesc desc;
  desc.positions = View<double3>(positions);
  desc.springs = springs;
  desc.material.stiffness = options.stiffness;
  Fabric fabric = take(context.cook(desc), "network");
  return {std::move(context), fabric, options};
}

SteppedWorld SteppedWorld::mesh(const std::vector<double3>& positions,
                                const std::vector<uint32_t>& triangles, const Options& options) {
  Context context = make_context(options);
  MeshDesc desc;
  desc.positions = View<double3>(positions);
  desc.indices = triangles;
  desc.material.stiffness = options.stiffness;
  Fabric fabric = take(context.cook(desc), "mesh");
  return {std::move(context), fabric, options};
}

void SteppedWorld::advance() {
  const Status status = world_.step(dt_);
  if (status != Status::ok) throw std::runtime_error(std::string("step: ") + to_string(status));
}

double SteppedWorld::bytes_per_step() {
  const PlanInfo plan = take(world_.plan(), "plan");
  double bytes = 0;
  for (uint32_t i = 0; i < plan.passes.count; ++i) {
    const PassInfo& pass = plan.passes[i];
    if (std::strcmp(pass.per, "substep") == 0)
      bytes += pass.bytes_per_particle * double(pass.count);
  }
  return bytes;
}

TriangleSheet triangle_sheet(uint32_t n) {
  TriangleSheet sheet;
  for (uint32_t v = 0; v < n * n; ++v) {
    sheet.positions.push_back({double(v % n) / (n - 1), double(v / n) / (n - 1), 0});
  }
  for (uint32_t r = 0; r + 1 < n; ++r) {
    for (uint32_t c = 0; c + 1 < n; ++c) {
      const uint32_t a = r * n + c;
      for (const uint32_t v : {a, a + 1, a + n + 1, a, a + n + 1, a + n})
        sheet.triangles.push_back(v);
    }
  }
  return sheet;
}

}  // namespace weft::bench
