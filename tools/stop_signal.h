// Being asked to stop: by Ctrl-C, by kill, or because the terminal is gone.
#pragma once

#include <functional>
#include <string>

namespace weft::tools {

/// From now on SIGINT, SIGTERM and SIGHUP are only noted. Two seconds later the program ends in the
/// middle of what it does, with exit code 3, a message and no file that is not whole, unless it has
/// begun to stop by itself.
void catch_stop_signals();
/// The number of the signal that came; 0 for none.
int stop_signal();
/// The program has noticed the signal and will end without further ado.
void begin_to_stop();

/// What the program does, for the message: "frame 3 of 10". `rescue` is called before the program
/// ends in the middle of it, on another thread, and must not touch what the work uses.
class LongWork {
 public:
  explicit LongWork(std::string what, std::function<void()> rescue = {});
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;
  ~LongWork();
};

}  // namespace weft::tools
