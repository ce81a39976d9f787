// The figures of a run.
#pragma once

#include "weft/world.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace weft::io {

struct ReportEvent {
  std::string type;
  std::optional<size_t> cloth;  ///< none: not about a cloth
  uint32_t vertex = 0;
  double time = 0;
  std::string text;
};
struct ReportPhase {
  std::string name;
  double seconds;
};

struct Report {
  std::string backend, device, isa, precision;
  std::string evaluation = "gather";
  uint32_t threads = 0;
  uint64_t particles = 0, springs = 0, frames = 0, steps = 0;
  uint32_t substeps_per_frame = 0;
  double dt = 0, dt_bound = 0;                ///< a bound of infinity is written as null
  double wall_seconds = 0, cpu_seconds = 0;   ///< in steps; CPU time of all threads
  uint64_t contacts = 0, pairs_excluded = 0;  ///< of self-collision, at the end
  std::vector<ReportPhase> phases;
  uint64_t bytes_state = 0, bytes_total = 0;
  std::vector<ReportEvent> events;
  Mechanics mechanics{};
  double largest_stretch = 0;  ///< (l - l0)/l0 of a spring, in the frames written and at the end
  uint64_t state_hash = 0;
  uint64_t asleep = 0;  ///< cloths

  /// Null without steps.
  std::optional<double> ns_per_particle_step() const;
};

/// Keys in the order of the format's page.
nlohmann::ordered_json to_json(const Report&);
/// 16 lower-case hex digits.
std::string hash_text(uint64_t hash);
void write_report(const std::string& path, const Report&);

}  // namespace weft::io
