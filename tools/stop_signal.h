// Being asked to stop: by Ctrl-C or by kill.
#pragma once

namespace weft::tools {

/// From now on SIGINT and SIGTERM are only noted.
void catch_stop_signals();
/// The number of the signal that came; 0 for none.
int stop_signal();

}  // namespace weft::tools
