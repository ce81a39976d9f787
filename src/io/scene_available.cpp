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

const char* name_of(const ColliderScene& collider) {
  static constexpr const char* names[] = {"sphere", "plane", "cylinder", "capsule", "box"};
  return names[collider.shape.index()];
}

void refuse_solver(const SolverSettings& solver) {
  if (solver.integrator != Integrator::verlet) {
    refuse("$.solver.integrator", name_of(solver.integrator), "give \"verlet\"");
  }
  if (solver.evaluation == Evaluation::scatter) {
    refuse("$.solver.evaluation", "\"scatter\"", "give \"gather\" or \"auto\"");
  }
  if (solver.energy_guard == EnergyGuard::on) {
    refuse("$.solver.energy_guard", "true", "give false or \"auto\"");
  }
}

void refuse_collider(const ColliderScene& collider, size_t index) {
  const std::string path = "$.colliders[" + std::to_string(index) + "]";
  const bool simple = std::holds_alternative<SphereDesc>(collider.shape) ||
                      std::holds_alternative<PlaneDesc>(collider.shape);
  if (!simple) {
    refuse(path + "." + name_of(collider), std::string("a ") + name_of(collider),
           "give a sphere or a plane");
  }
  if (collider.friction > 0) {
    refuse(path + ".friction", number_text(collider.friction), "give 0");
  }
}

}  // namespace

void refuse_unavailable(const Scene& scene) {
  refuse_solver(scene.solver);
  for (size_t i = 0; i < scene.colliders.size(); ++i) refuse_collider(scene.colliders[i], i);
  if (scene.wind) refuse("$.wind", "wind", "give null");
  if (scene.self_collision) refuse("$.self_collision", "self-collision", "give null");
}

}  // namespace weft::io
