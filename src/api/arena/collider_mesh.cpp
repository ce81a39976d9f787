#include <utility>

#include "api/arena/collider_mesh_arrays.h"
#include "api/context/context_state.h"
#include "plan/cutter.h"

namespace weft {
inline namespace v0 {

ColliderMesh::ColliderMesh(const ColliderMesh& other) noexcept : impl_(other.impl_) {
  if (impl_) impl_->references.fetch_add(1, std::memory_order_relaxed);
}
ColliderMesh::ColliderMesh(ColliderMesh&& other) noexcept
    : impl_(std::exchange(other.impl_, nullptr)) {}
ColliderMesh& ColliderMesh::operator=(ColliderMesh other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}
ColliderMesh::~ColliderMesh() {
  if (!impl_ || impl_->references.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
  const std::shared_ptr<api::ContextState> keep = impl_->context;  // its memory
  delete impl_;
}

uint64_t ColliderMesh::triangle_count() const noexcept {
  return impl_ ? impl_->cooked.triangles : 0;
}

uint64_t ColliderMesh::bytes() const noexcept {
  if (!impl_) return 0;
  TriangleGrid<float> grid{};
  plan::ArrayBytes bytes;
  grid.arrays(bytes, api::grid_counts(impl_->cooked));
  return bytes.bytes();
}

View<Diagnostic> ColliderMesh::diagnostics() const noexcept {
  if (!impl_) return {};
  return {impl_->diagnostics.data(), impl_->diagnostics.size()};
}

}  // namespace v0
}  // namespace weft
