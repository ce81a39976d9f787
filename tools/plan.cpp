// weft plan: the passes that a scene needs, and nothing else.
#include "commands.h"

#include "arguments.h"
#include "output.h"

#include "io/build.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace weft::tools {
namespace {

void print_table(const PlanInfo& plan, bool as_forces) {
  int width = 6;
  for (uint32_t i = 0; i < plan.passes.count; ++i) {
    width = std::max(width, int(std::strlen(plan.passes[i].kernel)));
  }
  char line[512];
  std::snprintf(line, sizeof line, "%-12s %-8s %-*s %12s %15s %15s\n", "stage", "per", width,
                "kernel", "count", "bytes/particle", "flops/particle");
  std::string text = line;
  for (uint32_t i = 0; i < plan.passes.count; ++i) {
    const PassInfo& pass = plan.passes[i];
    std::snprintf(line, sizeof line, "%-12s %-8s %-*s %12llu %15.1f %15.1f\n", pass.stage, pass.per,
                  width, pass.kernel, static_cast<unsigned long long>(pass.count),
                  pass.bytes_per_particle, pass.flops_per_particle);
    text += line;
  }
  for (uint32_t i = 0; as_forces && i < plan.evaluations.count; ++i) {
    const EvaluationInfo& e = plan.evaluations[i];
    std::snprintf(line, sizeof line,
                  "cloth %u: %s (model, ns per substep on one thread: gather %.0f, scatter %.0f)\n",
                  i, to_string(e.chosen), e.gather_ns, e.scatter_ns);
    text += line;
  }
  print(text + "memory " + bytes_text(double(plan.bytes_total)) + "\n");
}

}  // namespace

int plan_command(const CommonOptions& options) {
  const ContextDesc desc = context_desc(options);
  const io::Scene scene = io::read_scene(options.scene);
  io::RunningScene made = io::build(scene, desc);
  const auto planned = made.world.plan();
  made.require(planned.status(), scene.file);
  const PlanInfo& plan = *planned;
  if (!options.json) {
    print_table(plan, scene.solver.method == io::Method::verlet);
    return done;
  }
  nlohmann::ordered_json json{{"passes", nlohmann::ordered_json::array()}};
  for (uint32_t i = 0; i < plan.passes.count; ++i) {
    const PassInfo& pass = plan.passes[i];
    json["passes"].push_back({{"stage", pass.stage},
                              {"per", pass.per},
                              {"kernel", pass.kernel},
                              {"count", pass.count},
                              {"bytes_per_particle", pass.bytes_per_particle},
                              {"flops_per_particle", pass.flops_per_particle}});
  }
  json["evaluations"] = nlohmann::ordered_json::array();
  for (uint32_t i = 0; i < plan.evaluations.count; ++i) {
    const EvaluationInfo& e = plan.evaluations[i];
    json["evaluations"].push_back({{"cloth", i},
                                   {"chosen", to_string(e.chosen)},
                                   {"gather_ns", e.gather_ns},
                                   {"scatter_ns", e.scatter_ns}});
  }
  json["bytes_total"] = plan.bytes_total;
  print_json(json);
  return done;
}

}  // namespace weft::tools
