// Runs of random calls, each in several ways. In the environment:
//   WEFT_DRIVER_SEED     seed of the first run, 1 unless given; the next has one more
//   WEFT_DRIVER_SECONDS  for how long runs are begun, 2 unless given
//   WEFT_DRIVER_CALLS    calls of a run, 150 unless given: fewer to come near what a crash needs
//   WEFT_DRIVER_SAY      not empty: each call is printed before it is made
#include "run.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace weft_tests::driver {
namespace {

uint64_t given(const char* name, uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text && *text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// What a run that ends the process would have said.
char last_words[256];
void say_last_words() {
  [[maybe_unused]] const ssize_t written = write(2, last_words, std::strlen(last_words));
}
void note(uint64_t seed, const char* way, size_t call) {
  std::snprintf(last_words, sizeof last_words,
                "driver: seed %llu, %s, call %zu: WEFT_DRIVER_SEED=%llu WEFT_DRIVER_CALLS=%zu "
                "WEFT_DRIVER_SAY=1 shows it\n",
                static_cast<unsigned long long>(seed), way, call,
                static_cast<unsigned long long>(seed), call + 1);
}
extern "C" void die_loudly(int signal) {
  say_last_words();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}
extern "C" void __attribute__((weak)) __sanitizer_set_death_callback(void (*)());

constexpr Way base{"one thread", 1, false, false, false, false};
constexpr Way ways[] = {{"one thread again", 1, false, false, false, false},
                        {"three threads", 3, false, false, false, false},
                        {"the caller's jobs", 1, true, false, false, false},
                        {"without the calls that failed", 1, false, false, true, false},
                        {"out of memory on the way", 1, false, true, false, false}};

struct Result {
  std::vector<Entry> trace;
  std::string finding;  ///< empty: none
  std::string calls;    ///< the last ones
};

/// Makes `count` calls in one way, but for those that `left_out` names.
Result run(uint64_t seed, Way way, size_t count, const std::vector<bool>& left_out) {
  way.says = given("WEFT_DRIVER_SAY", 0) != 0;
  Result result;
  size_t call = 0;
  Run made(seed, way);
  try {
    for (; call < count; ++call) {
      note(seed, way.name, call);
      alarm(120);  // what hangs is found, too
      if (call < left_out.size() && left_out[call]) {
        made.leave_out(uint32_t(call));
      } else {
        made.call(uint32_t(call));
      }
    }
    result.trace = made.trace();
    result.calls = made.last_calls(12);
    made.finish();
  } catch (const Finding& finding) {
    result.trace = made.trace();
    result.calls = made.last_calls(12);
    result.finding = printed("%s, call %zu: ", way.name, call) + finding.what();
  }
  alarm(0);
  return result;
}

/// Where two traces differ; empty: nowhere.
std::string difference(const Result& a, const Result& b, const char* way) {
  for (size_t i = 0; i < std::min(a.trace.size(), b.trace.size()); ++i) {
    const Entry &x = a.trace[i], &y = b.trace[i];
    if (!x.name || !y.name) continue;
    const char* what = x.status != y.status   ? "status"
                       : x.result != y.result ? "result"
                       : !x.seen || !y.seen   ? nullptr
                       : x.seen != y.seen     ? "state"
                                              : nullptr;
    if (what) {
      return printed("%s, call %zu, %s: another %s (%s and %s)", way, i, x.name, what,
                     weft::to_string(x.status), weft::to_string(y.status));
    }
  }
  return "";
}

/// Calls that changed nothing, as documented: what follows is the same without them.
bool changed_nothing(const Entry& entry) {
  if (!entry.name || entry.status == weft::Status::ok) return false;
  return entry.status != weft::Status::diverged && std::strcmp(entry.name, "advance") != 0;
}

/// A finding, or none, of the first `count` calls.
std::string finding_of(uint64_t seed, size_t count, std::vector<bool> left_out,
                       std::string* calls) {
  const Result first = run(seed, base, count, left_out);
  if (calls) *calls = first.calls;
  if (!first.finding.empty()) return first.finding;
  for (const Way& way : ways) {
    std::vector<bool> without = left_out;
    without.resize(count, false);
    for (size_t i = 0; way.quiet && i < count; ++i) {
      if (changed_nothing(first.trace[i])) without[i] = true;
    }
    const Result other = run(seed, way, count, without);
    if (calls) *calls = other.calls;
    if (!other.finding.empty()) return other.finding;
    if (const std::string d = difference(first, other, way.name); !d.empty()) return d;
  }
  return "";
}

/// The number of the call that a finding names, and one.
size_t calls_of(const std::string& finding, size_t otherwise) {
  const size_t at = finding.find(", call ");
  return at == finding.npos ? otherwise : std::strtoull(finding.c_str() + at + 7, nullptr, 10) + 1;
}

/// What a finding says, without where and without its numbers.
std::string kind_of(const std::string& finding) {
  const size_t at = finding.find(": ");
  const std::string kind = at == finding.npos ? finding : finding.substr(at);
  return kind.substr(0, kind.find_first_of("0123456789"));
}

/// Leaves out call after call as long as the finding stays, for some seconds.
std::string shortened(uint64_t seed, size_t count, std::string* finding) {
  const std::string kind = kind_of(*finding);
  const auto begin = std::chrono::steady_clock::now();
  std::vector<bool> left_out(count, false);
  std::string calls;
  for (size_t chunk = std::max<size_t>(count / 4, 1);; chunk /= 2) {
    for (size_t end = count; end > 0; end -= std::min(end, chunk)) {
      std::vector<bool> fewer = left_out;
      for (size_t i = end - std::min(end, chunk); i < end; ++i) fewer[i] = true;
      if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(10)) break;
      const std::string told = finding_of(seed, count, fewer, nullptr);
      if (told.empty() || kind_of(told) != kind) continue;
      left_out = fewer;
      *finding = told;
    }
    if (chunk == 1) break;
  }
  finding_of(seed, calls_of(*finding, count), left_out, &calls);
  return calls;
}

TEST(RandomCalls, KeepWhatTheInterfacePromises) {
  std::signal(SIGALRM, die_loudly);
  if (__sanitizer_set_death_callback) {
    __sanitizer_set_death_callback(say_last_words);
  } else {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL}) std::signal(signal, die_loudly);
  }
  const auto begin = std::chrono::steady_clock::now();
  const std::chrono::seconds most(given("WEFT_DRIVER_SECONDS", 2));
  const uint64_t first = given("WEFT_DRIVER_SEED", 1);
  const size_t count = given("WEFT_DRIVER_CALLS", 150);
  uint64_t seed = first;
  do {
    std::string finding = finding_of(seed, count, {}, nullptr);
    if (finding.empty()) continue;
    const std::string whole = finding;
    const std::string calls = shortened(seed, calls_of(finding, count), &finding);
    FAIL() << "seed " << seed << ", " << whole << "\nrun again with WEFT_DRIVER_SEED=" << seed
           << "; with fewer calls, the last of which are\n"
           << calls << finding;
  } while (++seed && std::chrono::steady_clock::now() - begin < most);
  std::printf("%llu runs of %zu calls in %zu ways\n", static_cast<unsigned long long>(seed - first),
              count, std::size(ways) + 1);
}

}  // namespace
}  // namespace weft_tests::driver
