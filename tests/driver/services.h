// What a caller brings: memory that is counted and can run out, a log, threads.
#pragma once

#include "weft/weft.hpp"

#include <cstdarg>
#include <cstdio>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace weft_tests::driver {

/// A promise that was not kept.
struct Finding : std::runtime_error {
  using std::runtime_error::runtime_error;
};

__attribute__((format(printf, 1, 2))) inline std::string printed(const char* format, ...) {
  char text[512];
  va_list list;
  va_start(list, format);
  std::vsnprintf(text, sizeof text, format, list);
  va_end(list);
  return text;
}
template <class... Values>
void require(bool held, const char* format, Values... values) {
  if (!held) throw Finding(printed(format, values...));
}
inline void require(bool held, const char* what) {
  if (!held) throw Finding(what);
}

/// Every block is known by its address and size; `left` blocks are given before there are none.
class Heap {
 public:
  static constexpr uint64_t endless = ~uint64_t(0);

  weft::Allocator hooks();
  size_t blocks() const { return sizes_.size(); }
  uint64_t bytes() const { return bytes_; }
  /// What was wrong with a call, else null: found where an exception may not pass.
  const char* fault() const { return fault_; }

  uint64_t left = endless;

 private:
  static void* allocate(void* self, size_t bytes, size_t alignment);
  static void deallocate(void* self, void* memory, size_t bytes);

  std::mutex mutex_;
  std::map<void*, size_t> sizes_;
  uint64_t bytes_ = 0;
  const char* fault_ = nullptr;
};

/// Counts errors and keeps the last.
class Book {
 public:
  weft::Log hooks() { return {this, message}; }
  void clear() {
    errors = 0;
    last.clear();
  }

  uint32_t errors = 0;
  std::string last;

 private:
  static void message(void* self, weft::Severity, const char* text);
  std::mutex mutex_;
};

/// Two workers; ranges come in an order of their own, now and then on another thread.
class Pool {
 public:
  weft::Jobs hooks();
  ~Pool();
  const char* fault() const { return fault_; }

 private:
  static void parallel_for(void* self, uint32_t count, uint32_t grain,
                           void (*fn)(void*, uint32_t, uint32_t), void* context, const char* name);
  static void launch(void* self, void (*fn)(void*), void* context, const char* name);

  std::mutex mutex_;
  std::vector<std::thread> threads_;
  uint32_t calls_ = 0;
  const char* fault_ = nullptr;
};

}  // namespace weft_tests::driver
