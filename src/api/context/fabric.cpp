#include <utility>

#include "api/context/context_state.h"

namespace weft {
inline namespace v0 {

Fabric::Fabric(const Fabric& other) noexcept : impl_(other.impl_) {
  if (impl_) impl_->references.fetch_add(1, std::memory_order_relaxed);
}
Fabric::Fabric(Fabric&& other) noexcept : impl_(std::exchange(other.impl_, nullptr)) {}
Fabric& Fabric::operator=(Fabric other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}
Fabric::~Fabric() {
  if (!impl_ || impl_->references.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
  const std::shared_ptr<api::ContextState> keep = impl_->context;  // its memory
  delete impl_;
}

uint32_t Fabric::vertex_count() const noexcept { return impl_ ? impl_->cooked.vertices : 0; }
uint32_t Fabric::render_vertex_count() const noexcept {
  return impl_ ? impl_->cooked.render_vertices() : 0;
}
Status Fabric::read_particles(uint32_t* out) const noexcept {
  const uint32_t count = render_vertex_count();
  if (count == 0) return Status::ok;
  if (!out) {
    return impl_->context->fail(Status::invalid_argument,
                                "particles into a null pointer (there is no room) give a buffer");
  }
  const auto& particle_of = impl_->cooked.particle_of;
  for (uint32_t v = 0; v < count; ++v) out[v] = particle_of.empty() ? v : particle_of[v];
  return Status::ok;
}
uint64_t Fabric::spring_count() const noexcept { return impl_ ? impl_->cooked.springs : 0; }
uint64_t Fabric::triangle_count() const noexcept {
  return impl_ ? scene::triangle_count(impl_->cooked) : 0;
}

Status Fabric::read_triangles(uint64_t first, uint64_t count, uint32_t* out) const noexcept {
  if (count == 0) return Status::ok;
  if (!impl_) return Status::invalid_handle;
  const uint64_t all = triangle_count();
  if (first > all || count > all - first || !out) {
    return impl_->context->fail(
        Status::invalid_argument,
        text("triangles [%llu, +%llu) (the fabric has %llu) ask for fewer, into a buffer",
             static_cast<unsigned long long>(first), static_cast<unsigned long long>(count),
             static_cast<unsigned long long>(all)));
  }
  for (uint64_t t = 0; t < count; ++t) scene::triangle(impl_->cooked, first + t, out + 3 * t);
  return Status::ok;
}

View<Diagnostic> Fabric::diagnostics() const noexcept {
  if (!impl_) return {};
  return {impl_->diagnostics.data(), impl_->diagnostics.size()};
}

}  // namespace v0
}  // namespace weft
