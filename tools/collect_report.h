// The figures of a run, asked from the world.
#pragma once

#include "io/build.h"
#include "io/report.h"

namespace weft::tools {

/// Adds the world's events of the last step, and once the fallback of the back end.
void collect_events(const io::RunningScene&, std::vector<io::ReportEvent>&);
void collect_fallback(const io::RunningScene&, std::vector<io::ReportEvent>&);

/// Everything but the events.
void collect_figures(const io::Scene&, io::RunningScene&, io::Report&);

}  // namespace weft::tools
