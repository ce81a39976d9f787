// PC2 point caches: the positions of a mesh's vertices over time, as modelling programs play them.
//
// The file, little-endian: "POINTCACHE2\0", int32 version 1, int32 points, float32 first frame,
// float32 samples per frame, int32 samples; then per sample and point three float32.
#pragma once

#include "weft/core.hpp"

#include "io/output_file.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace weft::io {

struct PointCache {
  uint32_t points = 0, samples = 0;
  float start = 0;                ///< frame of the first sample
  float rate = 1;                 ///< samples per frame, > 0
  std::vector<float3> positions;  ///< sample by sample
};

/// InputError names the file, what is wrong and where. Sizes are checked before memory is taken.
PointCache read_point_cache(const std::string& path);
/// The same from memory; `name` goes into messages.
PointCache read_point_cache(std::string_view bytes, const std::string& name);

/// Writes sample after sample; the file appears with commit(). OutputError on failure.
class PointCacheWriter {
 public:
  PointCacheWriter(const std::string& path, size_t points, float start = 0, float rate = 1);

  /// `positions`: as many as points; rounded to float.
  void add(const double3* positions);
  void commit();

 private:
  std::string path_;
  OutputFile file_;
  size_t points_;
  uint32_t samples_ = 0;
  std::vector<char> record_;
};

}  // namespace weft::io
