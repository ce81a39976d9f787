// The scenes that stretch is measured on: sheets of 2 m and 1 kg that hang, lie or swing, and a
// hundred capes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "weft/weft.hpp"

namespace weft::bench {

/// How a scene is integrated.
struct Method {
  std::string name;
  Integrator integrator = Integrator::xpbd;
  Stiffness stiffness = 1e5;
  uint32_t substeps = 0;                          ///< of a frame; 0: automatic
  std::vector<uint8_t> ladder{automatic_ladder};  ///< empty: none
  bool tethered = false;
};

enum class StretchScene {
  edge,    ///< swings down from one row
  pin,     ///< hangs from its corners
  sphere,  ///< falls on a sphere of 0.5 m
  capes    ///< 100 of 20 x 18, from their upper rows, before three capsules each that sway
};
const char* to_string(StretchScene);

/// Of the structural springs of all cloths, length/rest - 1.
struct Stretched {
  double p99 = 0, largest = 0;
};
/// Of all cloths together.
struct Energies {
  double height = 0;  ///< m: of the centre of mass
  double kinetic = 0, potential = 0;
};

class StretchRun {
 public:
  StretchRun(StretchScene, uint32_t n, const Method&, uint32_t threads);
  ~StretchRun();
  StretchRun(const StretchRun&) = delete;
  StretchRun& operator=(const StretchRun&) = delete;

  /// A frame of 1/60 s. Returns the seconds of the step: CPU on one thread, else wall.
  double frame();
  Stretched stretch() const;
  Energies energies() const;
  uint32_t substeps() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weft::bench
