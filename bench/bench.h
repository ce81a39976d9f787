// The benchmark tables behind `weft bench`.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace weft::bench {

struct Row {
  std::string bench, name;  ///< `name` is the key "case" of the JSON output
  std::string metric, unit;
  double median, min, max;
  int n;  ///< samples behind the median
};

struct Table {
  const char* name;
  const char* summary;
  std::vector<Row> (*run)(bool quick, std::ostream& progress);
};

const std::vector<Table>& tables();

}  // namespace weft::bench
