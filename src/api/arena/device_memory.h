// The block of device memory that an arena is cut from.
#pragma once

#include <algorithm>
#include <utility>

#include "api/context/context_state.h"

namespace weft::api {

class DeviceMemory {
 public:
  explicit DeviceMemory(ContextState& context) : context_(context) {}
  ~DeviceMemory() { release(); }
  DeviceMemory(const DeviceMemory&) = delete;
  DeviceMemory& operator=(const DeviceMemory&) = delete;

  char* data() const { return at_; }
  size_t bytes() const { return bytes_; }

  Status allocate(size_t bytes) {
    bytes = std::max<size_t>(bytes, 1);  // a world may be empty
    at_ = static_cast<char*>(context_.backend->allocate(context_.memory.hooks(), bytes));
    if (!at_) {
      return context_.fail(
          Status::out_of_memory,
          text("no %zu bytes of device memory (the scene needs them) make it smaller", bytes));
    }
    bytes_ = bytes;
    count(static_cast<std::ptrdiff_t>(bytes));
    return Status::ok;
  }
  void swap(DeviceMemory& other) {
    std::swap(at_, other.at_);
    std::swap(bytes_, other.bytes_);
  }
  void release() {
    if (!at_) return;
    context_.backend->release(context_.memory.hooks(), at_, bytes_);
    count(-static_cast<std::ptrdiff_t>(bytes_));
    at_ = nullptr;
  }

 private:
  /// The host's is counted where it comes from.
  void count(std::ptrdiff_t bytes) {
    if (!context_.backend->info().host_memory) context_.memory.count(bytes);
  }

  ContextState& context_;
  char* at_ = nullptr;
  size_t bytes_ = 0;
};

}  // namespace weft::api
