// A thread that runs one function at a time for World::begin_step. It is made for the first.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace weft::api {

class Runner {
 public:
  Runner() = default;
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Makes the thread, if there is one to be had. Throws std::bad_alloc.
  void make();
  /// False: there is no thread, and nothing happens. The function before must have ended.
  bool start(void (*function)(void*), void* argument) noexcept;

 private:
  void loop();

  std::thread thread_;
  std::mutex mutex_;
  std::condition_variable wakes_;
  void (*function_)(void*) = nullptr;
  void* argument_ = nullptr;
  bool closing_ = false;
};

}  // namespace weft::api
