#include "api/context/memory.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace weft::api {

void* ContextMemory::allocate_hook(void* self, size_t bytes, size_t alignment) {
  auto& memory = *static_cast<ContextMemory*>(self);
  const size_t align = std::max(alignment, alignof(std::max_align_t));
  void* p =
      memory.user_.allocate
          ? memory.user_.allocate(memory.user_.user, bytes, align)
          : std::aligned_alloc(align, (std::max<size_t>(bytes, 1) + align - 1) / align * align);
  if (p) memory.held_ += static_cast<std::ptrdiff_t>(bytes);
  return p;
}

void ContextMemory::deallocate_hook(void* self, void* p, size_t bytes) {
  if (!p) return;
  auto& memory = *static_cast<ContextMemory*>(self);
  memory.held_ -= static_cast<std::ptrdiff_t>(bytes);
  if (memory.user_.deallocate) {
    memory.user_.deallocate(memory.user_.user, p, bytes);
  } else {
    std::free(p);
  }
}

void* ContextMemory::do_allocate(size_t bytes, size_t alignment) {
  void* p = allocate_hook(this, bytes, alignment);
  if (!p) throw std::bad_alloc();
  return p;
}

void ContextMemory::do_deallocate(void* p, size_t bytes, size_t) {
  deallocate_hook(this, p, bytes);
}

}  // namespace weft::api
