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

const char* name_of(Method method) {
  switch (method) {
    case Method::verlet:
      return "\"verlet\"";
    case Method::rk4:
      return "\"rk4\"";
    case Method::implicit_euler:
      return "\"implicit_euler\"";
    case Method::implicit_midpoint:
      return "\"implicit_midpoint\"";
    case Method::xpbd:
      return "\"xpbd\"";
  }
  return "";
}

void refuse_solver(const SolverSettings& solver) {
  if (solver.method != Method::verlet && solver.method != Method::xpbd) {
    refuse("$.solver.integrator", name_of(solver.method), "give \"verlet\" or \"xpbd\"");
  }
  if (solver.energy_guard == EnergyGuard::on) {
    refuse("$.solver.energy_guard", "true", "give false or \"auto\"");
  }
}

}  // namespace

void refuse_unavailable(const Scene& scene) { refuse_solver(scene.solver); }

}  // namespace weft::io
