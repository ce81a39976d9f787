// Sine and cosine with the same bits on every processor (the C library picks variants by
// processor).
#pragma once

namespace weft::scene {

struct SineCosine {
  double sine, cosine;
};
/// Of any angle in radians; error below 3e-16, exact at 0. NaN of what is not finite.
SineCosine sine_cosine(double radians);
/// Of an angle in degrees; exact at multiples of 90.
SineCosine sine_cosine_degrees(double degrees);

}  // namespace weft::scene
