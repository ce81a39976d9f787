// Host memory of the library: containers and objects take it from the context whose call they are
// made in, so that all of it passes through the caller's allocator and is counted. Host code only.
#pragma once

#include <cstddef>
#include <limits>
#include <memory_resource>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace weft {

/// Where this thread takes host memory from; null: the C++ heap.
inline thread_local std::pmr::memory_resource* memory_of_thread = nullptr;

inline std::pmr::memory_resource* host_memory() noexcept {
  return memory_of_thread ? memory_of_thread : std::pmr::new_delete_resource();
}

/// As long as it lives, this thread takes its host memory from `memory`.
class MemoryScope {
 public:
  explicit MemoryScope(std::pmr::memory_resource* memory) noexcept : before_(memory_of_thread) {
    memory_of_thread = memory;
  }
  ~MemoryScope() { memory_of_thread = before_; }
  MemoryScope(const MemoryScope&) = delete;
  MemoryScope& operator=(const MemoryScope&) = delete;

 private:
  std::pmr::memory_resource* before_;
};

/// Takes from where the thread does when the container is made, and gives back to the same place.
template <class T>
class HostAllocator {
 public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  HostAllocator() noexcept : memory_(host_memory()) {}
  template <class Other>
  HostAllocator(const HostAllocator<Other>& other) noexcept : memory_(other.resource()) {}

  T* allocate(size_t count) {
    if (count > std::numeric_limits<size_t>::max() / sizeof(T)) throw std::bad_alloc();
    return static_cast<T*>(memory_->allocate(count * sizeof(T), alignof(T)));
  }
  void deallocate(T* at, size_t count) noexcept {
    memory_->deallocate(at, count * sizeof(T), alignof(T));
  }
  HostAllocator select_on_container_copy_construction() const noexcept { return {}; }
  std::pmr::memory_resource* resource() const noexcept { return memory_; }
  template <class Other>
  bool operator==(const HostAllocator<Other>& other) const noexcept {
    return memory_ == other.resource();
  }

 private:
  std::pmr::memory_resource* memory_;
};

template <class T>
using Vector = std::vector<T, HostAllocator<T>>;
using String = std::basic_string<char, std::char_traits<char>, HostAllocator<char>>;

/// A base of classes whose objects come from host memory. Who deletes one that holds the last
/// reference to that memory keeps another meanwhile.
class HostObject {
 public:
  static void* operator new(size_t bytes) {
    std::pmr::memory_resource* memory = host_memory();
    void* at = memory->allocate(bytes + header, header);
    *static_cast<std::pmr::memory_resource**>(at) = memory;
    return static_cast<char*>(at) + header;
  }
  static void operator delete(void* object, size_t bytes) noexcept {
    void* at = static_cast<char*>(object) - header;
    (*static_cast<std::pmr::memory_resource**>(at))->deallocate(at, bytes + header, header);
  }

 private:
  static constexpr size_t header = 16;
  static_assert(header >= sizeof(void*) && header % alignof(std::max_align_t) == 0);
};

}  // namespace weft
