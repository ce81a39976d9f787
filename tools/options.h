// What the command line asks for, as text; arguments.h turns it into values.
#pragma once

#include <string>
#include <vector>

namespace weft::tools {

struct CommonOptions {
  std::string scene;
  std::string backend = "auto", isa = "auto", threads;
  bool json = false;
};

struct RunOptions : CommonOptions {
  std::string time, out, every, format, size, final_file, report;
  bool normals = false;
};

struct BenchOptions {
  std::vector<std::string> names;
  bool list = false, quick = false, json = false;
};

}  // namespace weft::tools
