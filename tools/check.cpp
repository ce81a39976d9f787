// weft check: is the scene valid, how large is it, which step is stable, what is odd about it.
#include "commands.h"

#include "arguments.h"
#include "missed_pairs.h"
#include "output.h"
#include "remarks.h"
#include "step_bound.h"
#include "windless.h"

#include "io/build.h"
#include "io/scene_size.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace weft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct Finding {
  const char* severity;
  std::optional<size_t> cloth;  ///< none: the whole scene
  uint32_t element;
  std::string text;
  bool names_cloth = false;  ///< the text says which cloth it is
};

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::info:
      return "info";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "";
}

std::vector<Finding> find_all(const io::Scene& scene, io::RunningScene& made,
                              const Stability& stability, uint64_t planned) {
  std::vector<Finding> findings;
  for (Remark& r : remarks(scene, made)) {
    // What names its collider names no cloth.
    std::string text = r.collider ? subject(scene, r) + r.text : std::move(r.text);
    findings.push_back({name_of(r.severity), r.cloth, r.element, std::move(text)});
  }
  for (Windless& cloth : windless_cloths(scene, made)) {
    findings.push_back({"warning", cloth.cloth, 0, std::move(cloth.text), true});
  }
  for (MissedPairs& missed : missed_pairs(scene)) {
    findings.push_back(
        {missed.grave ? "warning" : "info", std::nullopt, 0, std::move(missed.text)});
  }
  if (const auto problem = io::beyond_memory(io::bytes_to_run(scene, planned))) {
    findings.push_back({"warning", std::nullopt, 0, *problem});
  }
  if (const auto problem = beyond_bound(scene, made, stability)) {
    findings.push_back(
        {"warning", made.index_of(stability.cloth), stability.a, "$.time.substeps: " + *problem});
  }
  return findings;
}

/// What "auto" takes. XPBD has no bound that would say: a world without a number of its own does.
uint64_t automatic_substeps(io::Scene scene, const Stability& stability,
                            const ContextDesc& context) {
  if (scene.solver.method != io::Method::xpbd) {
    return fewest_substeps(scene.time.frame, scene.solver.safety * stability.dt_bound);
  }
  scene.time.substeps = 0;
  io::RunningScene made = io::build(scene, context);
  const auto substeps = made.world.substeps(scene.time.frame);
  return substeps ? *substeps : 0;
}

void print_human(const io::Scene& scene, const io::RunningScene& made, const Stats& stats,
                 const Stability& stability, uint64_t automatic, uint64_t bytes,
                 const std::vector<Finding>& findings) {
  std::string bound = "unlimited";
  if (std::isfinite(stability.dt_bound)) {
    bound = seconds_text(stability.dt_bound) + ", set by " + worst_element(scene, made, stability);
  }
  std::vector<std::pair<std::string, std::string>> lines{
      {"scene", scene.file},
      {"particles", std::to_string(stats.particles)},
      {"springs", std::to_string(stats.springs)},
      {"step bound", bound},
      {"substeps", scene.time.substeps ? std::to_string(scene.time.substeps) +
                                             " (auto would take " + std::to_string(automatic) + ")"
                                       : std::to_string(automatic) + " (auto)"},
      {"memory", bytes_text(double(bytes))}};
  for (const Finding& finding : findings) {
    const std::string cloth = finding.cloth && !finding.names_cloth
                                  ? "cloth '" + scene.cloths[*finding.cloth].name + "': "
                                  : "";
    lines.push_back({finding.severity, cloth + finding.text});
  }
  print_lines(lines);
}

}  // namespace

int check_command(const CommonOptions& options) {
  const ContextDesc desc = context_desc(options);
  const io::Scene scene = io::read_scene(options.scene);
  io::RunningScene made = io::build(scene, desc);
  const Stability stability = made.world.stability();
  const Stats stats = made.world.stats();
  const auto planned = made.world.plan();
  made.require(planned.status(), scene.file);
  const PlanInfo& plan = *planned;
  const std::vector<Finding> findings = find_all(scene, made, stability, plan.bytes_total);
  if (!options.json) {
    print_human(scene, made, stats, stability, automatic_substeps(scene, stability, desc),
                plan.bytes_total, findings);
    return done;
  }
  Json json{{"particles", stats.particles}, {"springs", stats.springs}, {"dt_bound", nullptr}};
  if (std::isfinite(stability.dt_bound)) json["dt_bound"] = stability.dt_bound;
  json["bytes_total"] = plan.bytes_total;
  json["diagnostics"] = Json::array();
  for (const Finding& finding : findings) {
    json["diagnostics"].push_back({{"severity", finding.severity},
                                   {"cloth", finding.cloth ? Json(*finding.cloth) : Json(nullptr)},
                                   {"element", finding.element},
                                   {"text", finding.text}});
  }
  print_json(json);
  return done;
}

}  // namespace weft::tools
