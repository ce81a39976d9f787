#include "api/context/runner.h"

#include <system_error>

namespace weft::api {

Runner::~Runner() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wakes_.notify_one();
  thread_.join();
}

void Runner::make() {
  if (thread_.joinable()) return;
  try {
    thread_ = std::thread([this] { loop(); });
  } catch (const std::system_error&) {  // the system has no more threads
  }
}

bool Runner::start(void (*function)(void*), void* argument) noexcept {
  if (!thread_.joinable()) return false;
  {
    const std::lock_guard lock(mutex_);
    function_ = function;
    argument_ = argument;
  }
  wakes_.notify_one();
  return true;
}

void Runner::loop() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wakes_.wait(lock, [this] { return function_ || closing_; });
    if (!function_) return;
    void (*const function)(void*) = function_;
    function_ = nullptr;
    void* const argument = argument_;
    lock.unlock();
    function(argument);
    lock.lock();
  }
}

}  // namespace weft::api
