#include "bench/interleave.h"

#include <algorithm>
#include <chrono>

namespace weft::bench {

namespace {

Row row_of(const std::string& bench, const std::string& name, const std::string& metric,
           const std::string& unit, std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  const size_t n = samples.size();
  const double median = n % 2 == 1 ? samples[n / 2] : (samples[n / 2 - 1] + samples[n / 2]) / 2;
  return {bench, name, metric, unit, median, samples.front(), samples.back(), static_cast<int>(n)};
}

}  // namespace

size_t Interleaved::add(Candidate candidate) {
  candidates_.push_back(std::move(candidate));
  ns_.emplace_back();
  return candidates_.size() - 1;
}

void Interleaved::run(int rounds, std::ostream& progress) {
  using Clock = std::chrono::steady_clock;
  for (const Candidate& c : candidates_) c.call();  // warm-up
  for (int round = 0; round < rounds; ++round) {
    for (size_t i = 0; i < candidates_.size(); ++i) {
      const auto begin = Clock::now();
      candidates_[i].call();
      const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
      ns_[i].push_back(time.count() / candidates_[i].units);
    }
    progress << bench_ << ": round " << round + 1 << " of " << rounds << '\n';
  }
}

void Interleaved::append_times(const std::string& metric, const std::string& unit,
                               std::vector<Row>& rows) const {
  for (size_t i = 0; i < candidates_.size(); ++i) {
    rows.push_back(row_of(bench_, candidates_[i].name, metric, unit, ns_[i]));
  }
}

double Interleaved::median(size_t candidate) const {
  return row_of("", "", "", "", ns_[candidate]).median;
}

void Interleaved::append_ratio(const std::string& name, size_t slow, size_t fast,
                               std::vector<Row>& rows, double times) const {
  std::vector<double> ratios;
  for (size_t r = 0; r < ns_[slow].size(); ++r) {
    ratios.push_back(times * ns_[slow][r] / ns_[fast][r]);
  }
  rows.push_back(row_of(bench_, name, "ratio", "1", ratios));
}

void Interleaved::append_difference(const std::string& name, const std::string& unit, size_t more,
                                    size_t base, std::vector<Row>& rows) const {
  std::vector<double> added;
  for (size_t r = 0; r < ns_[more].size(); ++r) added.push_back(ns_[more][r] - ns_[base][r]);
  rows.push_back(row_of(bench_, name, "added", unit, added));
}

}  // namespace weft::bench
