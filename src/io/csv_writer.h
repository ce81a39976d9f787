// The final state as a table: cloth,vertex,x,y,z,vx,vy,vz with %.17g numbers.
#pragma once

#include "weft/core.hpp"

#include "io/output_file.h"

#include <span>
#include <string>

namespace weft::io {

class FinalWriter {
 public:
  explicit FinalWriter(const std::string& path);
  /// Appends the vertices of cloth number `cloth`, in order; both spans have the same length.
  void add_cloth(size_t cloth, std::span<const double3> positions,
                 std::span<const double3> velocities);
  void commit() { file_.commit(); }

 private:
  OutputFile file_;
};

}  // namespace weft::io
