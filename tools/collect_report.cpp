#include "collect_report.h"

#include <algorithm>

namespace weft::tools {

/// Sleep is a number of the report, not an event of its format.
/// What was chosen: "gather", "scatter", or "mixed" where cloths differ.
static std::string evaluation_of(World& world) {
  const auto plan = world.plan();
  if (!plan || (*plan).evaluations.count == 0) return "gather";
  const Evaluation first = (*plan).evaluations[0].chosen;
  for (uint32_t i = 1; i < (*plan).evaluations.count; ++i) {
    if ((*plan).evaluations[i].chosen != first) return "mixed";
  }
  return to_string(first);
}

static bool is_reported(EventType type) {
  return type != EventType::slept && type != EventType::woke;
}

void collect_events(const io::RunningScene& made, std::vector<io::ReportEvent>& events) {
  const View<Event> latest = made.world.events();
  for (uint32_t i = 0; i < latest.count; ++i) {
    const Event& event = latest[i];
    if (!is_reported(event.type)) continue;
    const size_t cloth = made.index_of(event.cloth);
    io::ReportEvent entry{
        to_string(event.type), {}, event.vertex, event.time, event.text ? event.text : ""};
    if (cloth < made.cloths.size()) entry.cloth = cloth;
    events.push_back(std::move(entry));
  }
}

void collect_fallback(const io::RunningScene& made, std::vector<io::ReportEvent>& events) {
  const char* reason = made.context.info().fallback;
  if (reason) events.push_back({to_string(EventType::backend_fallback), {}, 0, 0, reason});
}

void collect_figures(const io::Scene& scene, io::RunningScene& made, io::Report& report) {
  const ContextInfo info = made.context.info();
  report.backend = info.backend;
  report.device = info.device;
  report.isa = info.isa;
  report.precision = to_string(scene.solver.precision);
  const Stats stats = made.world.stats();
  report.threads = stats.steps > 0 ? stats.threads : info.threads;
  report.evaluation = evaluation_of(made.world);
  report.particles = stats.particles;
  report.springs = stats.springs;
  report.frames = stats.frames;
  report.steps = stats.steps;
  report.wall_seconds = stats.step_seconds;
  report.cpu_seconds = stats.cpu_seconds;
  report.bytes_state = stats.bytes_state;
  report.bytes_total = stats.bytes_total;
  report.dt_bound = made.world.stability().dt_bound;
  report.substeps_per_frame = stats.substeps_most;
  report.dt = stats.dt_least;
  if (stats.steps == 0) {
    report.substeps_per_frame = *made.world.substeps(scene.time.frame);
    report.dt = scene.time.frame / report.substeps_per_frame;
  }
  report.phases.clear();
  for (uint32_t i = 0; i < stats.phases.count; ++i) {
    report.phases.push_back({stats.phases[i].name, stats.phases[i].seconds});
  }
  report.mechanics = *made.world.mechanics();
  report.largest_stretch = std::max(report.largest_stretch, report.mechanics.stretch);
  report.state_hash = *made.world.state_hash();
  const auto contacts = made.world.contacts();
  made.require(contacts.status(), scene.file);
  report.contacts = contacts->touching;
  report.pairs_excluded = contacts->excluded;
  report.asleep = 0;
  for (const ClothId cloth : made.cloths) report.asleep += *made.world.asleep(cloth) ? 1 : 0;
}

}  // namespace weft::tools
