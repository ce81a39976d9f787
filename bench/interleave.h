// Interleaved timing: clocks drift by tens of percent over minutes, so every round times every
// candidate once, and ratios are taken round by round.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/bench.h"

namespace weft::bench {

struct Candidate {
  std::string name;
  double units;                ///< particle steps (or directed springs) of one call
  std::function<void()> call;  ///< a few milliseconds of work
};

class Interleaved {
 public:
  explicit Interleaved(std::string bench) : bench_(std::move(bench)) {}

  /// Returns the index of the candidate.
  size_t add(Candidate);
  void run(int rounds, std::ostream& progress);

  /// ns per unit of every candidate.
  void append_times(const std::string& metric, const std::string& unit, std::vector<Row>&) const;
  /// Median of the ns per unit of one of them.
  double median(size_t candidate) const;
  const std::string& name(size_t candidate) const { return candidates_[candidate].name; }
  /// Time per unit of `slow`, `times` that much, over that of `fast`, paired by round.
  void append_ratio(const std::string& name, size_t slow, size_t fast, std::vector<Row>&,
                    double times = 1) const;
  /// How much more time per unit `more` takes than `base`, paired by round.
  void append_difference(const std::string& name, const std::string& unit, size_t more, size_t base,
                         std::vector<Row>&) const;

 private:
  std::string bench_;
  std::vector<Candidate> candidates_;
  std::vector<std::vector<double>> ns_;  ///< by candidate and round
};

}  // namespace weft::bench
