// Memory of a context: every byte goes through the caller's allocator and is counted.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory_resource>
#include <new>

#include "weft/core.hpp"

namespace weft::api {

/// The caller's allocator, or the C++ heap's, without a context that counts: for what a context
/// itself lies in.
template <class T>
struct UncountedAllocator {
  using value_type = T;
  explicit UncountedAllocator(const Allocator& user) : of(user) {}
  template <class Other>
  UncountedAllocator(const UncountedAllocator<Other>& other) : of(other.of) {}

  T* allocate(size_t count) {
    static_assert(alignof(T) <= alignof(std::max_align_t));
    void* at = of.allocate ? of.allocate(of.user, count * sizeof(T), alignof(std::max_align_t))
                           : std::malloc(count * sizeof(T));
    if (!at) throw std::bad_alloc();
    return static_cast<T*>(at);
  }
  void deallocate(T* at, size_t count) noexcept {
    if (of.deallocate) return of.deallocate(of.user, at, count * sizeof(T));
    std::free(at);
  }
  template <class Other>
  bool operator==(const UncountedAllocator<Other>&) const {
    return true;
  }

  Allocator of;
};

class UncountedMemory final : public std::pmr::memory_resource {
 public:
  explicit UncountedMemory(const Allocator& user) : memory_(user) {}

 private:
  void* do_allocate(size_t bytes, size_t) override { return memory_.allocate(bytes); }
  void do_deallocate(void* at, size_t bytes, size_t) override {
    memory_.deallocate(static_cast<char*>(at), bytes);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  UncountedAllocator<char> memory_;
};

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
