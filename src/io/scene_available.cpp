// What the format has and this version does not simulate yet.
#include "io/scene_parts.h"

#include "io/error.h"
#include "io/text_cursor.h"

namespace weft::io {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& value, const char* remedy) {
  throw InputError(path + ": " + value +
                   " is not available in this version (its effect is not "
                   "simulated yet) " +
                   remedy);
}

const char* name_of(Integrator integrator) {
  switch (integrator) {
    case Integrator::verlet:
      return "\"verlet\"";
    case Integrator::rk4:
      return "\"rk4\"";
    case Integrator::implicit_euler:
      return "\"implicit_euler\"";
    case Integrator::implicit_midpoint:
      return "\"implicit_midpoint\"";
    case Integrator::xpbd:
      return "\"xpbd\"";
  }
  return "";
}

void refuse_solver(const SolverSettings& solver) {
  if (solver.integrator != Integrator::verlet) {
    refuse("$.solver.integrator", name_of(solver.integrator), "give \"verlet\"");
  }
  if (solver.energy_guard == EnergyGuard::on) {
    refuse("$.solver.energy_guard", "true", "give false or \"auto\"");
  }
}

}  // namespace

void refuse_unavailable(const Scene& scene) { refuse_solver(scene.solver); }

}  // namespace weft::io
