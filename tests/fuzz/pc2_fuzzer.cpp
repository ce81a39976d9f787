// Any bytes as a point cache: finite points, or refused with an InputError.
#include "io/point_cache.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const weft::io::PointCache cache = weft::io::read_point_cache(text_of(data, size), "a.pc2");
    require(cache.positions.size() == size_t(cache.points) * cache.samples);
    for (const weft::float3& p : cache.positions) require(std::isfinite(p.x + p.y * 0 + p.z * 0));
  } catch (const weft::io::InputError& error) {
    require_message(error);
  }
  return 0;
}
