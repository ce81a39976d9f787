#include "io/report.h"

#include "io/output_file.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace weft::io {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson finite_or_null(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

OrderedJson events_json(const std::vector<ReportEvent>& events) {
  OrderedJson list = OrderedJson::array();
  for (const ReportEvent& event : events) {
    OrderedJson entry{{"type", event.type},
                      {"cloth", nullptr},
                      {"vertex", nullptr},
                      {"time", finite_or_null(event.time)},
                      {"text", event.text}};
    if (event.cloth) {
      entry["cloth"] = *event.cloth;
      entry["vertex"] = event.vertex;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

void add_mechanics(OrderedJson& json, const Mechanics& mechanics) {
  json["energy"] = {{"kinetic", finite_or_null(mechanics.kinetic)},
                    {"elastic", finite_or_null(mechanics.elastic)},
                    {"potential", finite_or_null(mechanics.potential)}};
  const double3 p = mechanics.momentum;
  json["momentum"] =
      OrderedJson::array({finite_or_null(p.x), finite_or_null(p.y), finite_or_null(p.z)});
}

}  // namespace

std::optional<double> Report::ns_per_particle_step() const {
  const double work = double(particles) * double(steps);
  if (work == 0) return std::nullopt;
  return wall_seconds * 1e9 / work;
}

nlohmann::ordered_json to_json(const Report& report) {
  OrderedJson json{{"backend", report.backend},
                   {"device", report.device},
                   {"threads", report.threads},
                   {"isa", report.isa},
                   {"precision", report.precision},
                   {"evaluation", report.evaluation},
                   {"particles", report.particles},
                   {"springs", report.springs},
                   {"frames", report.frames},
                   {"substeps_per_frame", report.substeps_per_frame},
                   {"dt", report.dt},
                   {"dt_bound", finite_or_null(report.dt_bound)},
                   {"steps", report.steps},
                   {"wall_seconds", report.wall_seconds},
                   {"cpu_seconds", report.cpu_seconds}};
  const auto cost = report.ns_per_particle_step();
  json["ns_per_particle_step"] = cost ? OrderedJson(*cost) : OrderedJson(nullptr);
  json["contacts"] = report.contacts;
  json["pairs_excluded"] = report.pairs_excluded;
  json["phases"] = OrderedJson::array();
  for (const ReportPhase& phase : report.phases) {
    json["phases"].push_back({{"name", phase.name}, {"seconds", phase.seconds}});
  }
  json["bytes_state"] = report.bytes_state;
  json["bytes_total"] = report.bytes_total;
  json["events"] = events_json(report.events);
  add_mechanics(json, report.mechanics);
  json["largest_stretch"] = finite_or_null(report.largest_stretch);
  json["state_hash"] = hash_text(report.state_hash);
  json["asleep"] = report.asleep;
  return json;
}

std::string hash_text(uint64_t hash) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text(16, '0');
  for (size_t i = 0; i < 16; ++i) text[15 - i] = digits[(hash >> (4 * i)) & 15];
  return text;
}

void write_report(const std::string& path, const Report& report) {
  OutputFile file(path, Sync::yes);
  file.write(to_json(report).dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
  file.commit();
}

}  // namespace weft::io
