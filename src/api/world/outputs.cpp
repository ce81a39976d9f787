// Vertices on their way out: outputs and bounds.
#include <algorithm>
#include <cmath>

#include "api/world/call_guard.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"

namespace weft {
inline namespace v0 {

api::OutputRecord* World::Impl::find(OutputId id) noexcept {
  if (!id || id.index >= outputs.size() || outputs[id.index].id != id) return nullptr;
  return &outputs[id.index];
}

Result<OutputId> World::bind_output(ClothId id, const OutputDesc& desc) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  const api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  OutputId made;
  const Status status = api::guarded(*impl_->context, [&] {
    const uint32_t vertices = cloth->cooked().render_vertices();
    api::check_output(desc, vertices);
    api::OutputRecord record;
    record.cloth = id;
    record.desc = desc;
    if (api::is_wanted(desc.layout.last_position)) record.last.resize(vertices);
    made = impl_->output_ids.take(impl_->outputs);
    record.id = made;
    impl_->outputs[made.index] = std::move(record);
    if (api::is_wanted(desc.layout.normal)) impl_->want_normals();
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return made;
}

Status World::unbind_output(OutputId id) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  api::OutputRecord* output = impl_->find(id);
  if (!output) return impl_->stale("output", id.index);
  *output = {};
  impl_->output_ids.give_back(id.index);
  return Status::ok;
}

Status World::set_output_memory(OutputId id, void* memory, uint64_t bytes) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  api::OutputRecord* output = impl_->find(id);
  if (!output) return impl_->stale("output", id.index);
  return api::guarded(*impl_->context, [&] {
    OutputDesc changed = output->desc;
    changed.memory = memory;
    changed.bytes = bytes;
    if (memory || bytes > 0) {
      api::check_memory(changed, impl_->find(output->cloth)->cooked().render_vertices());
    }
    output->desc = changed;
    return Status::ok;
  });
}

/// What the kernel needs of an output; `record_only`: it takes down the positions and writes none.
static api::VertexTarget target_of(const api::ClothRecord& cloth, api::OutputRecord& output,
                                   double alpha, bool record_only) {
  const OutputDesc& desc = output.desc;
  const auto attribute = [&](const Attribute& a) {
    if (record_only || !api::is_wanted(a)) return VertexAttribute{VertexFormat::none, nullptr, 0};
    char* first = static_cast<char*>(desc.memory) + a.offset + size_t(desc.first_vertex) * a.stride;
    return VertexAttribute{static_cast<VertexFormat>(a.format), first, a.stride};
  };
  static_assert(int(VertexFormat::oct16x2) == int(Format::oct16x2));
  static_assert(sizeof(Vec3<float>) == sizeof(float3));
  return {alpha,
          api::minus(cloth.origin, desc.origin),
          output.last.empty() ? nullptr : reinterpret_cast<Vec3<float>*>(output.last.data()),
          attribute(desc.layout.position),
          attribute(desc.layout.normal),
          attribute(desc.layout.last_position)};
}

Status World::write_outputs(double alpha) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  const api::Zone zone(*impl_->context, "weft write_outputs");
  return api::guarded(*impl_->context, [&] {
    if (!(alpha >= 0 && alpha <= 1)) {
      throw InvalidInput(
          text("alpha is %g (the way from the step before to the last one) give a value in [0, 1]",
               alpha));
    }
    if (alpha < 1 && !impl_->desc.interpolate) {
      throw InvalidInput(
          text("alpha is %g (this world does not keep the step before) set WorldDesc::interpolate",
               alpha));
    }
    bool normals = false;
    for (const api::OutputRecord& output : impl_->outputs) {
      if (!output.id) continue;
      normals |= api::is_wanted(output.desc.layout.normal);
      if (output.desc.memory) continue;
      throw InvalidInput(
          text("output %u has no memory (its vertices must go somewhere) call set_output_memory",
               output.id.index));
    }
    Status status = impl_->outputs.empty() ? Status::ok : impl_->ensure_readable();
    if (status == Status::ok && normals) status = impl_->make_result(api::StateArray::normal);
    for (api::OutputRecord& output : impl_->outputs) {
      if (status != Status::ok) break;
      if (!output.id) continue;
      const api::ClothRecord& cloth = *impl_->find(output.cloth);
      if (!output.last.empty() && !output.has_last) {
        status = impl_->arena->write(cloth, target_of(cloth, output, alpha, true),
                                     impl_->context->workers());
        output.has_last = status == Status::ok;
      }
      if (status == Status::ok) {
        status = impl_->arena->write(cloth, target_of(cloth, output, alpha, false),
                                     impl_->context->workers());
      }
    }
    return status;
  });
}

/// Where a vertex of a cloth that has not moved is, as the arena will hold it; `narrow`: in float.
static double3 at_start(const api::ClothRecord& cloth, uint32_t v, bool narrow) {
  const double3 x = api::minus(api::start_position(cloth, v), cloth.origin);
  return api::plus(cloth.origin, narrow ? api::rounded_to_float(x) : x);
}

void World::Impl::publish_bounds(api::ClothRecord& cloth) const {
  Bounds now{api::plus(cloth.low, cloth.origin), api::plus(cloth.high, cloth.origin)};
  Bounds shown = now;
  if (desc.interpolate) {
    const Bounds& b = cloth.bounds_before;
    shown.low = {std::min(now.low.x, b.low.x), std::min(now.low.y, b.low.y),
                 std::min(now.low.z, b.low.z)};
    shown.high = {std::max(now.high.x, b.high.x), std::max(now.high.y, b.high.y),
                  std::max(now.high.z, b.high.z)};
  }
  cloth.bounds = shown;
  told.set_bounds(cloth.id, shown);
  cloth.bounds_before = now;
}

Result<Bounds> World::bounds(ClothId id) const noexcept {
  if (!impl_) return Status::invalid_handle;
  Bounds bounds{};
  if (!impl_->told.find(id, &bounds)) return impl_->stale("cloth", id.index);
  return bounds;
}

void World::Impl::start_bounds_of(api::ClothRecord& cloth) const {
  Bounds b{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (uint32_t v = 0; v < cloth.cooked().vertices; ++v) {
    const double3 x = at_start(cloth, v, desc.precision == Precision::float32);
    b.low = {std::min(b.low.x, x.x), std::min(b.low.y, x.y), std::min(b.low.z, x.z)};
    b.high = {std::max(b.high.x, x.x), std::max(b.high.y, x.y), std::max(b.high.z, x.z)};
  }
  cloth.bounds = cloth.bounds_before = b;
}

}  // namespace v0
}  // namespace weft
