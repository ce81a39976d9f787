// The files of a run must not take each other's place, nor that of what it reads.
#pragma once

#include "frame_output.h"

#include <map>
#include <string>

namespace weft::tools {

class OutputPaths {
 public:
  explicit OutputPaths(const io::Scene&);

  /// InputError, naming `option`, when the place is taken.
  void add(const std::string& option, const std::string& path);
  /// All that `--out` will write.
  void add_frames(const FrameSettings&, const io::Scene&);

 private:
  std::map<std::string, std::string> taken_;  ///< what it is, by canonical path
};

}  // namespace weft::tools
