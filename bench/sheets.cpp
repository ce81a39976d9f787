#include "bench/sheets.h"

#include <stdexcept>

namespace weft::bench {

namespace {

template <class T>
T take(Result<T> result, const char* what) {
  if (!result) throw std::runtime_error(std::string(what) + ": " + to_string(result.status()));
  return std::move(*result);
}

Context make_context(uint32_t threads) {
  ContextDesc desc;
  desc.backend = BackendKind::omp;
  desc.threads = threads;
  return take(Context::create(desc), "context");
}

}  // namespace

SteppedWorld::SteppedWorld(Context context, Fabric fabric, const Options& options)
    : context_(std::move(context)), substeps_(options.substeps) {
  WorldDesc desc;
  desc.precision = options.precision;
  desc.substeps = static_cast<uint32_t>(substeps_);
  world_ = take(context_.create_world(desc), "world");
  ClothDesc cloth;
  cloth.fabric = fabric;
  if (options.dress) options.dress(cloth);
  cloth_ = take(world_.create_cloth(cloth), "cloth");
  if (options.furnish) options.furnish(context_, world_, cloth_);
  particles_ = fabric.vertex_count();
  directed_springs_ = 2 * fabric.spring_count();
  dt_ = 0.9 * substeps_ * world_.stability().dt_bound;
  advance();
}

SteppedWorld SteppedWorld::sheet(uint32_t n, Stencil stencil, const Options& options) {
  Context context = make_context(options.threads);
  GridDesc desc;
  desc.rows = desc.columns = n;
  desc.stencil = stencil;
  desc.material.stiffness = options.stiffness;
  Fabric fabric = take(context.cook(desc), "grid");
  return {std::move(context), fabric, options};
}

SteppedWorld SteppedWorld::mesh(const std::vector<double3>& positions,
                                const std::vector<uint32_t>& triangles, const Options& options) {
  Context context = make_context(options.threads);
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
