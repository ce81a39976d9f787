// A progress bar on standard error, for people only.
#pragma once

#include <chrono>
#include <cstdint>

namespace weft::tools {

/// Shows nothing unless standard error is a terminal and more than a second has passed.
class Progress {
 public:
  explicit Progress(uint64_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< wipes the line

  void update(uint64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  uint64_t total_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_ = begin_ + std::chrono::seconds(1);
};

}  // namespace weft::tools
