#include "stop_signal.h"

#include "commands.h"
#include "output.h"

#include "io/temporary_file.h"

#include <chrono>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace weft::tools {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto look = std::chrono::milliseconds(100);
constexpr const char* usual = "the run";
constexpr auto patience = std::chrono::milliseconds(1700);

std::atomic<int> came{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler writes it");

extern "C" void note(int number) { came = number; }

/// What the main thread does, as the watching one sees it.
struct Work {
  std::mutex mutex;
  bool stops = false;
  std::string what;
  std::function<void()> rescue;
};

// Never destroyed: the thread that looks at it ends with the program.
Work& work() {
  static Work& only = *new Work;
  return only;
}

[[noreturn]] void end_in_the_middle(const Work& now) {
  try {
    if (now.rescue) now.rescue();
  } catch (const std::exception& error) {
    print_message(error.what());
  }
  io::TemporaryFile::remove_all();
  print_message("stopped in the middle of " + now.what + " (signal " + std::to_string(came) +
                ", and what it did took long) run it again, with less to do at once");
  std::_Exit(stopped);
}

void watch() {
  Clock::time_point asked{};
  for (;;) {
    std::this_thread::sleep_for(look);
    if (came == 0) continue;
    if (asked == Clock::time_point{}) asked = Clock::now();
    if (Clock::now() - asked < patience) continue;
    const std::lock_guard<std::mutex> lock(work().mutex);
    if (!work().stops) end_in_the_middle(work());
  }
}

}  // namespace

void catch_stop_signals() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
  std::signal(SIGHUP, note);
  work().what = usual;
  std::thread(watch).detach();
}

int stop_signal() { return came; }

void begin_to_stop() {
  const std::lock_guard<std::mutex> lock(work().mutex);
  work().stops = true;
}

LongWork::LongWork(std::string what, std::function<void()> rescue) {
  const std::lock_guard<std::mutex> lock(work().mutex);
  work().what = std::move(what);
  work().rescue = std::move(rescue);
}

// Waits for ever when the program is ending.
LongWork::~LongWork() {
  const std::lock_guard<std::mutex> lock(work().mutex);
  work().what = usual;
  work().rescue = {};
}

}  // namespace weft::tools
