#include "api/context/vector_math.h"

#include "base/message_host.h"
#include "scene/check.h"
#include "scene/trigonometry.h"

namespace weft::api {

double3 checked_vector(const double3& v, const char* field) {
  scene::check_finite(v.x, field);
  scene::check_finite(v.y, field);
  scene::check_finite(v.z, field);
  return v;
}

void rotation_rows(const double3& axis, double degrees, const char* of, double3* rows) {
  checked_vector(axis, text("%s.axis", of).c_str());
  scene::check_finite(degrees, text("%s.degrees", of).c_str());
  if (degrees == 0) {
    rows[0] = {1, 0, 0};
    rows[1] = {0, 1, 0};
    rows[2] = {0, 0, 1};
    return;
  }
  const double size = length(axis);
  if (!(size > 0) || !std::isfinite(size)) {
    throw InvalidInput(
        text("%s.axis is (%g, %g, %g) (it has no direction) give an axis of ordinary length, "
             "or 0 degrees",
             of, axis.x, axis.y, axis.z));
  }
  const double x = axis.x / size, y = axis.y / size, z = axis.z / size;
  const auto [s, c] = scene::sine_cosine_degrees(degrees);
  const double t = 1 - c;
  rows[0] = {t * x * x + c, t * x * y - s * z, t * x * z + s * y};
  rows[1] = {t * x * y + s * z, t * y * y + c, t * y * z - s * x};
  rows[2] = {t * x * z - s * y, t * y * z + s * x, t * z * z + c};
}

/// Through memory: where g++ 12 vectorises the way to float and back, it leaves both out.
double3 rounded_to_float(const double3& v) {
  volatile float x = static_cast<float>(v.x), y = static_cast<float>(v.y),
                 z = static_cast<float>(v.z);
  return {double(x), double(y), double(z)};
}

}  // namespace weft::api
