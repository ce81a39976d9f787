// Sine and cosine with the same bits on every processor (the C library picks variants by
// processor).
#pragma once

namespace weft::scene {

struct SineCosine {
  double sine, cosine;
};
/// Of an angle in radians; error below 2e-16 relative to 1 for |angle| < 1e6, exact at 0.
SineCosine sine_cosine(double radians);
/// Of an angle in degrees; exact at multiples of 90.
SineCosine sine_cosine_degrees(double degrees);

}  // namespace weft::scene
