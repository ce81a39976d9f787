#include "stop_signal.h"

#include <csignal>

namespace weft::tools {

static volatile std::sig_atomic_t came = 0;
static void note(int number) { came = number; }

void catch_stop_signals() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

int stop_signal() { return int(came); }

}  // namespace weft::tools
