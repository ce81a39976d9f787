// The commands. Each prints to standard output and returns its exit code, or throws.
#pragma once

#include "options.h"

namespace weft::tools {

enum ExitCode : int { done = 0, bad_input = 2, stopped = 3, not_available = 4 };

int run_command(const RunOptions&);
int check_command(const CommonOptions&);
int plan_command(const CommonOptions&);
int recall_command(const CommonOptions&);
int bench_command(const BenchOptions&);

}  // namespace weft::tools
