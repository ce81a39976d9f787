#include "services.h"

#include <algorithm>
#include <cstdlib>

namespace weft_tests::driver {

weft::Allocator Heap::hooks() { return {this, allocate, deallocate}; }

void* Heap::allocate(void* self, size_t bytes, size_t alignment) {
  auto& heap = *static_cast<Heap*>(self);
  const std::lock_guard lock(heap.mutex_);
  if (alignment == 0 || (alignment & (alignment - 1)) != 0) {
    heap.fault_ = "an alignment that is no power of two";
    return nullptr;
  }
  if (heap.left == 0) return nullptr;
  if (heap.left != endless) --heap.left;
  if (bytes > size_t(1) << 28) return nullptr;  // more than a small world can want
  const size_t size = (std::max<size_t>(bytes, 1) + alignment - 1) / alignment * alignment;
  void* at = std::aligned_alloc(alignment, size);
  if (!at) return nullptr;
  heap.sizes_[at] = bytes;
  heap.bytes_ += bytes;
  return at;
}

void Heap::deallocate(void* self, void* memory, size_t bytes) {
  auto& heap = *static_cast<Heap*>(self);
  const std::lock_guard lock(heap.mutex_);
  const auto at = heap.sizes_.find(memory);
  if (at == heap.sizes_.end()) {
    heap.fault_ = "memory is given back that was not taken";
    return;
  }
  if (at->second != bytes) heap.fault_ = "memory is given back with another size";
  heap.bytes_ -= at->second;
  heap.sizes_.erase(at);
  std::free(memory);
}

void Book::message(void* self, weft::Severity severity, const char* text) {
  auto& book = *static_cast<Book*>(self);
  const std::lock_guard lock(book.mutex_);
  if (severity != weft::Severity::error) return;
  ++book.errors;
  book.last = text;
}

weft::Jobs Pool::hooks() { return {this, 2, parallel_for, launch}; }

Pool::~Pool() {
  for (std::thread& thread : threads_) thread.join();
}

void Pool::parallel_for(void* self, uint32_t count, uint32_t grain,
                        void (*fn)(void*, uint32_t, uint32_t), void* context, const char* name) {
  auto& pool = *static_cast<Pool*>(self);
  uint32_t call;
  {
    const std::lock_guard lock(pool.mutex_);
    call = pool.calls_++;
    if (grain == 0 || !name) pool.fault_ = "parallel_for without a grain or a name";
  }
  const uint32_t middle = count / 3;
  if (call % 16 == 0 && middle > 0) {
    std::thread other([&] { fn(context, middle, count); });
    fn(context, 0, middle);
    other.join();
    return;
  }
  if (middle < count) fn(context, middle, count);
  for (uint32_t end = middle; end > 0;) {
    const uint32_t begin = end - std::min(end, std::max(grain, 1u));
    fn(context, begin, end);
    end = begin;
  }
}

void Pool::launch(void* self, void (*fn)(void*), void* context, const char* name) {
  auto& pool = *static_cast<Pool*>(self);
  const std::lock_guard lock(pool.mutex_);
  if (!name) pool.fault_ = "launch without a name";
  pool.threads_.emplace_back(fn, context);
}

}  // namespace weft_tests::driver
