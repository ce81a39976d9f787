// Memory of a context: every byte goes through the caller's allocator and is counted.
#pragma once

#include <atomic>
#include <memory_resource>

#include "weft/core.hpp"

namespace weft::api {

class ContextMemory final : public std::pmr::memory_resource {
 public:
  explicit ContextMemory(const Allocator& user) : user_(user) {}

  /// For back ends; counts what passes.
  Allocator hooks() noexcept { return {this, allocate_hook, deallocate_hook}; }
  /// Device memory that does not pass through the hooks.
  void count(std::ptrdiff_t bytes) noexcept { held_ += bytes; }
  uint64_t held() const noexcept { return static_cast<uint64_t>(held_.load()); }

 private:
  void* do_allocate(size_t bytes, size_t alignment) override;
  void do_deallocate(void* memory, size_t bytes, size_t alignment) override;
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  static void* allocate_hook(void* self, size_t bytes, size_t alignment);
  static void deallocate_hook(void* self, void* memory, size_t bytes);

  Allocator user_;
  std::atomic<std::ptrdiff_t> held_{0};
};

}  // namespace weft::api
