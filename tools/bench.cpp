// weft bench: the tables of the benchmark library, when this build has it.
#include "commands.h"

#include "output.h"

#include "io/error.h"

#include <nlohmann/json.hpp>

#if defined(WEFT_HAVE_BENCH)

#  include "bench/bench.h"

#  include <cstdio>
#  include <iostream>

namespace weft::tools {
namespace {

using Json = nlohmann::ordered_json;

int list_tables(bool json) {
  Json names = Json::array();
  std::vector<std::pair<std::string, std::string>> lines;
  for (const bench::Table& table : bench::tables()) {
    names.push_back({{"bench", table.name}, {"summary", table.summary}});
    lines.push_back({table.name, table.summary});
  }
  if (json)
    print_json({{"benches", names}});
  else
    print_lines(lines);
  return done;
}

std::vector<const bench::Table*> chosen_tables(const std::vector<std::string>& names) {
  std::vector<const bench::Table*> chosen;
  std::string known;
  for (const bench::Table& table : bench::tables()) {
    known += (known.empty() ? "" : ", ") + std::string(table.name);
    if (names.empty()) chosen.push_back(&table);
  }
  for (const std::string& name : names) {
    const size_t before = chosen.size();
    for (const bench::Table& table : bench::tables()) {
      if (name == table.name) chosen.push_back(&table);
    }
    if (chosen.size() == before) {
      throw io::InputError("bench: '" + name + "' is not a table (--list names them) give one of " +
                           known);
    }
  }
  return chosen;
}

void print_rows(const bench::Table& table, const std::vector<bench::Row>& rows) {
  std::string text = std::string(table.name) + ": " + table.summary + "\n";
  char line[512];
  for (const bench::Row& row : rows) {
    std::snprintf(line, sizeof line, "  %-44s %-22s %12s %-8s [%s .. %s] n=%d\n", row.name.c_str(),
                  row.metric.c_str(), figure(row.median).c_str(), row.unit.c_str(),
                  figure(row.min).c_str(), figure(row.max).c_str(), row.n);
    text += line;
  }
  print(text);
}

}  // namespace

int bench_command(const BenchOptions& options) {
  if (options.list) return list_tables(options.json);
  Json json{{"rows", Json::array()}};
  for (const bench::Table* table : chosen_tables(options.names)) {
    const std::vector<bench::Row> rows = table->run(options.quick, std::cerr);
    if (!options.json) print_rows(*table, rows);
    for (const bench::Row& row : rows) {
      json["rows"].push_back({{"bench", row.bench},
                              {"case", row.name},
                              {"metric", row.metric},
                              {"unit", row.unit},
                              {"median", row.median},
                              {"min", row.min},
                              {"max", row.max},
                              {"n", row.n}});
    }
  }
  if (options.json) print_json(json);
  return done;
}

}  // namespace weft::tools

#else

namespace weft::tools {

int bench_command(const BenchOptions&) {
  throw io::InputError(
      "bench: is not available in this build (it was made without benchmarks) build with "
      "-DWEFT_BUILD_BENCH=ON");
}

}  // namespace weft::tools

#endif
