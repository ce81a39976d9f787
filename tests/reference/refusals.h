// Checks that a call refuses a value: the status, a message that names the field and the element,
// and a world that did not change by a bit.
#pragma once

#include "reference/world_helpers.h"

#include <functional>
#include <limits>

namespace weft_tests {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// What a field refuses that must be finite, at least 0, or more.
inline const std::vector<double> not_finite{infinity, -infinity, not_a_number};
inline const std::vector<double> negative{-1, -infinity, infinity, not_a_number};
inline const std::vector<double> not_positive{0, -1, -infinity, infinity, not_a_number};

/// A field of a description and values that it refuses.
template <class Desc>
struct BadField {
  const char* name;
  std::function<void(Desc&, double)> set;
  std::vector<double> values;
};

/// Refused with `status` and a message with each of `words`.
inline void expect_refusal(TestWorld& test, weft::Status actual,
                           const std::vector<std::string>& words,
                           weft::Status status = weft::Status::invalid_argument) {
  EXPECT_EQ(actual, status);
  for (const std::string& word : words)
    EXPECT_NE(test.log().find(word), std::string::npos)
        << "the message does not name " << word << ": " << test.log();
  test.clear_log();
}

/// Runs `call` and expects that it is refused and that `test`'s world is bitwise what it was.
template <class Call>
void expect_refused_unchanged(TestWorld& test, const std::vector<std::string>& words, Call call,
                              weft::Status status = weft::Status::invalid_argument) {
  const uint64_t before = test.hash();
  const double time = test.world().time();
  const weft::Stats stats = test.world().stats();
  test.clear_log();
  expect_refusal(test, call(), words, status);
  EXPECT_EQ(test.hash(), before);
  EXPECT_EQ(test.world().time(), time);
  EXPECT_EQ(test.world().stats().steps, stats.steps);
  EXPECT_EQ(test.world().stats().particles, stats.particles);
  EXPECT_EQ(test.world().stats().springs, stats.springs);
}

}  // namespace weft_tests
