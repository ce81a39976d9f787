// Being asked to stop: by Ctrl-C or by kill.
#pragma once

#include <functional>
#include <string>

namespace weft::tools {

/// From now on SIGINT and SIGTERM are only noted, and a run ends when it comes to it.
void catch_stop_signals();
/// The number of the signal that came; 0 for none.
int stop_signal();

/// Work that nothing interrupts, such as a frame. When a signal came and the work goes on for two
/// more seconds, the program ends in the middle of it, with exit code 3 and a message, after
/// `rescue`, which runs beside the work and must not touch what it uses. One at a time.
class LongWork {
 public:
  /// "frame 3 of 10"
  explicit LongWork(std::string what, std::function<void()> rescue = {});
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;
  ~LongWork();
};

}  // namespace weft::tools
