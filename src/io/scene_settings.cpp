// The keys "time" and "solver".
#include "io/scene_parts.h"

namespace weft::io {
namespace {

void read_methods(const Node& node, SolverSettings& solver) {
  if (const auto key = node.find("integrator")) {
    solver.method = key->choice<Method>({{"verlet", Method::verlet},
                                         {"rk4", Method::rk4},
                                         {"implicit_euler", Method::implicit_euler},
                                         {"implicit_midpoint", Method::implicit_midpoint},
                                         {"xpbd", Method::xpbd}});
  }
  if (const auto key = node.find("form")) {
    solver.form = key->choice<Form>({{"summed", Form::summed}, {"position", Form::position}});
  }
  if (const auto key = node.find("start")) {
    solver.start = key->choice<Start>({{"taylor", Start::taylor}, {"lagged", Start::lagged}});
  }
  if (const auto key = node.find("precision")) {
    solver.precision =
        key->choice<Precision>({{"float32", Precision::float32}, {"float64", Precision::float64}});
  }
}

void read_evaluation(const Node& node, SolverSettings& solver) {
  if (const auto key = node.find("evaluation")) {
    solver.evaluation = key->choice<Evaluation>({{"gather", Evaluation::gather},
                                                 {"scatter", Evaluation::scatter},
                                                 {"auto", Evaluation::automatic}});
  }
  if (const auto key = node.find("deterministic")) solver.deterministic = key->boolean();
  const auto key = node.find("accumulate");
  if (!key) return;
  solver.accumulate = key->choice<Accumulate>({{"native", Accumulate::native},
                                               {"atomic", Accumulate::atomic},
                                               {"fixed64", Accumulate::fixed64},
                                               {"float16", Accumulate::float16},
                                               {"float24", Accumulate::float24},
                                               {"float24_all", Accumulate::float24_all},
                                               {"fixed8", Accumulate::fixed8}});
  if (solver.accumulate == Accumulate::atomic && solver.deterministic) {
    key->fail(
        "\"atomic\" is refused while deterministic is true (the order of atomic additions "
        "changes from run to run) set deterministic to false or choose another value");
  }
  if (solver.accumulate != Accumulate::native && solver.evaluation != Evaluation::scatter) {
    key->fail(key->value_text() +
              " needs evaluation \"scatter\" (a gather sums in registers) give "
              "\"native\" or set evaluation to \"scatter\"");
  }
}

/// Passes over the springs of a substep, and long springs.
void read_projection(const Node& node, SolverSettings& solver) {
  const bool projects = solver.method == Method::xpbd;
  if (const auto key = node.find("iterations")) {
    if (key->is_string()) {
      key->choice<int>({{"auto", 0}});
    } else if (key->integer(1, 1000000000, "a substep passes over the springs at least once") > 1 &&
               projects) {
      key->out_of_range("xpbd passes over its springs once a substep",
                        "give 1 or \"auto\", and more substeps");
    }
  }
  if (projects && solver.form == Form::position) {
    const Node form = node.at("form", "");
    form.out_of_range("xpbd keeps displacements", "give \"summed\"");
  }
  if (projects && solver.evaluation == Evaluation::scatter) {
    const Node evaluation = node.at("evaluation", "");
    evaluation.out_of_range("the springs of xpbd are constraints, and no forces to add up",
                            "give \"auto\"");
  }
  const auto key = node.find("ladder");
  if (!key) return;
  if (key->is_string()) {
    key->choice<int>({{"auto", 0}});
    return;
  }
  solver.ladder.clear();
  const size_t strides = key->array_size("strides, or \"auto\"");
  for (size_t k = 0; k < strides; ++k) {
    const Node stride = (*key)[k];
    if (k == sizeof WorldDesc::ladder) {
      stride.out_of_range("there are six strides at most", "leave out some");
    }
    const int64_t most = k > 0 ? solver.ladder.back() - 1 : 64;
    solver.ladder.push_back(uint8_t(stride.integer(2, most, "strides are 2 to 64, largest first")));
  }
}

void read_limits(const Node& node, SolverSettings& solver) {
  if (const auto key = node.find("safety")) {
    solver.safety = key->number(Sign::positive);
    if (solver.safety > 1) key->out_of_range("1 is the stable bound", "give a number > 0 and <= 1");
  }
  if (const auto key = node.find("energy_guard")) {
    if (key->is_string()) {
      key->choice<EnergyGuard>({{"auto", EnergyGuard::automatic}});
    } else {
      solver.energy_guard = key->boolean() ? EnergyGuard::on : EnergyGuard::off;
    }
  }
  if (const auto key = node.find("unsafe")) solver.unsafe = key->boolean();
}

}  // namespace

void read_time(const Node& node, TimeSettings& time) {
  node.require_object({"duration", "frame", "substeps", "max_substeps"});
  if (const auto key = node.find("duration")) time.duration = key->number(Sign::not_negative);
  if (const auto key = node.find("frame")) time.frame = key->number(Sign::positive);
  if (const auto most = node.find("max_substeps")) {
    time.max_substeps = uint32_t(most->integer(0, 1000000000, "0 is no limit"));
  }
  const auto key = node.find("substeps");
  if (!key) return;
  if (key->is_string()) {
    time.substeps = key->choice<uint32_t>({{"auto", 0}});
  } else {
    time.substeps = uint32_t(key->integer(1, 1000000000, "a frame takes 1 to 1e9 substeps"));
    if (time.max_substeps > 0 && time.substeps > time.max_substeps) {
      key->out_of_range("max_substeps is " + std::to_string(time.max_substeps),
                        "give at most that many, or raise max_substeps");
    }
  }
}

void read_solver(const Node& node, SolverSettings& solver) {
  node.require_object({"integrator", "form", "start", "precision", "evaluation", "accumulate",
                       "deterministic", "safety", "iterations", "ladder", "energy_guard",
                       "unsafe"});
  read_methods(node, solver);
  read_evaluation(node, solver);
  read_projection(node, solver);
  read_limits(node, solver);
}

}  // namespace weft::io
