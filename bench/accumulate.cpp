#include "bench/accumulate.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/random.h"
#include "weft/weft.hpp"

namespace weft::bench {

namespace {

constexpr uint32_t n = 16;
constexpr double side = 1, mass = 0.25, stiffness = 200, h = side / (n - 1);

struct Mode {
  const char* name;
  Precision precision;
  Evaluation evaluation;
  Accumulate accumulate;
  double fixed8_range = 1;
};
constexpr Evaluation scatter = Evaluation::scatter;
const Mode modes[] = {
    {"float64, gather", Precision::float64, Evaluation::gather, Accumulate::native},
    {"float32, gather", Precision::float32, Evaluation::gather, Accumulate::native},
    {"float32, atomic", Precision::float32, scatter, Accumulate::atomic},
    {"float32, fixed64", Precision::float32, scatter, Accumulate::fixed64},
    {"float32, float24", Precision::float32, scatter, Accumulate::float24},
    {"float32, float24_all", Precision::float32, scatter, Accumulate::float24_all},
    {"float32, float16", Precision::float32, scatter, Accumulate::float16},
    {"float32, fixed8", Precision::float32, scatter, Accumulate::fixed8},
    {"float32, fixed8, full scale 4 forces", Precision::float32, scatter, Accumulate::fixed8, 4},
    {"float64, float24", Precision::float64, scatter, Accumulate::float24},
    {"float64, float16", Precision::float64, scatter, Accumulate::float16},
    {"float64, fixed64", Precision::float64, scatter, Accumulate::fixed64},
    {"float64, fixed8", Precision::float64, scatter, Accumulate::fixed8},
};

double3 within(double half, Random& random) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return {half * (2 * x - 1), half * (2 * y - 1), half * (2 * z - 1)};
}

std::vector<double3> flat_sheet() {
  std::vector<double3> x;
  for (uint32_t v = 0; v < n * n; ++v) {
    x.push_back({(v % n) * h - side / 2, (v / n) * h - side / 2, 0});
  }
  return x;
}

/// Through memory: g++ 12 drops the round trip of two neighbouring numbers at -O2.
double as_float(double v) {
  const volatile float narrow = static_cast<float>(v);
  return static_cast<double>(narrow);
}

/// Rounded to float, so that every mode begins with the same positions.
std::vector<double3> shaken(std::vector<double3> x, double half) {
  Random random(1);
  for (double3& p : x) {
    const double3 by = within(half, random);
    p = {as_float(p.x + by.x), as_float(p.y + by.y), as_float(p.z + by.z)};
  }
  return x;
}

/// Spring forces in the plainest form: every spring once, in double.
std::vector<double3> forces_of(const std::vector<double3>& x) {
  constexpr int offsets[6][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 2}, {2, -2}};
  std::vector<double3> force(x.size(), {0, 0, 0});
  for (int v = 0; v < int(n * n); ++v) {
    for (const auto& o : offsets) {
      const int row = v / int(n) + o[0], column = v % int(n) + o[1];
      if (row >= int(n) || column < 0 || column >= int(n)) continue;
      double3 &a = force[size_t(v)], &b = force[size_t(row) * n + size_t(column)];
      const double3 p = x[size_t(v)], q = x[size_t(row) * n + size_t(column)];
      const double3 to{q.x - p.x, q.y - p.y, q.z - p.z};
      const double length = std::sqrt(to.x * to.x + to.y * to.y + to.z * to.z);
      const double tension = stiffness * (1 - h * std::hypot(o[0], o[1]) / length);
      a = {a.x + tension * to.x, a.y + tension * to.y, a.z + tension * to.z};
      b = {b.x - tension * to.x, b.y - tension * to.y, b.z - tension * to.z};
    }
  }
  return force;
}

template <class T>
T checked(Result<T> result) {
  if (!result) throw std::runtime_error(std::string("accumulate: ") + to_string(result.status()));
  return static_cast<T&&>(*result);
}
void check(Status status) {
  if (status != Status::ok)
    throw std::runtime_error(std::string("accumulate: ") + to_string(status));
}

/// The sheet of hard-cases in one mode, pinned at its corners or free and without weight.
class Sheet {
 public:
  Sheet(const Mode& mode, const std::vector<double3>& start, bool hangs) {
    ContextDesc device;
    device.backend = BackendKind::omp;
    device.threads = 1;
    context_ = checked(Context::create(device));
    WorldDesc desc;
    desc.gravity = {0, 0, hangs ? -9.81 : 0};
    desc.substeps = 1;
    desc.precision = mode.precision;
    desc.evaluation = mode.evaluation;
    desc.accumulate = mode.accumulate;
    desc.deterministic = mode.accumulate != Accumulate::atomic;
    desc.fixed8_range = mode.fixed8_range;
    world_ = checked(context_.create_world(desc));
    GridDesc grid;
    grid.rows = grid.columns = n;
    grid.material.mass.value = mass;
    grid.material.stiffness = stiffness;
    ClothDesc cloth;
    cloth.fabric = checked(context_.cook(grid));
    cloth.pose.translate = {-side / 2, -side / 2, 0};
    cloth.positions = View<double3>(start);
    const std::vector<Pin> pins{{0}, {n - 1}, {n * n - n}, {n * n - 1}};
    if (hangs) {
      cloth.pins = pins;
      cloth.drag = 4 * mass / (n * n);
    }
    cloth_ = checked(world_.create_cloth(cloth));
  }

  void advance(int steps) {
    const double dt = 0.8 * world_.stability().dt_bound;
    for (int i = 0; i < steps; ++i) check(world_.step(dt));
  }
  std::vector<double3> positions() {
    std::vector<double3> x(n * n);
    check(world_.read_positions(cloth_, x.data()));
    return x;
  }
  std::vector<double3> forces() {
    std::vector<double3> f(n * n);
    check(world_.read_accelerations(cloth_, f.data()));
    for (double3& v : f) v = {v.x * mass / (n * n), v.y * mass / (n * n), v.z * mass / (n * n)};
    return f;
  }

 private:
  Context context_;
  World world_;
  ClothId cloth_;
};

/// Root mean square of the difference, relative to that of `reference`.
double relative_error(const std::vector<double3>& values, const std::vector<double3>& reference) {
  double difference = 0, size = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    const double3 a = values[i], b = reference[i];
    difference += (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
    size += b.x * b.x + b.y * b.y + b.z * b.z;
  }
  return std::sqrt(difference / size);
}

double furthest(const std::vector<double3>& x, const std::vector<double3>& reference) {
  double most = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    most = std::max(most, std::hypot(x[i].x - reference[i].x, x[i].y - reference[i].y,
                                     x[i].z - reference[i].z));
  }
  return most;
}

Row row_of(const std::string& name, const char* metric, const char* unit, double value) {
  return {"accumulate", name, metric, unit, value, value, value, 1};
}

}  // namespace

std::vector<Row> run_accumulate(bool quick, std::ostream& progress) {
  Sheet exact(modes[0], flat_sheet(), true);
  exact.advance(60000);
  const std::vector<double3> rest = exact.positions();
  const struct {
    const char* name;
    std::vector<double3> x;
    bool hangs;  ///< weight and pins count too: what is left of large forces that cancel
  } states[] = {{"noise of 10 % h", shaken(flat_sheet(), 0.1 * h), false},
                {"noise of 1 % h", shaken(flat_sheet(), 0.01 * h), false},
                {"equilibrium + 1e-4 h", shaken(rest, 1e-4 * h), true}};
  std::vector<Row> rows;
  for (const auto& state : states) {
    std::vector<double3> expected = forces_of(state.x);
    if (state.hangs) {
      for (double3& f : expected) f.z -= 9.81 * mass / (n * n);
      for (const uint32_t pin : {0u, n - 1, n * n - n, n * n - 1}) expected[pin] = {0, 0, 0};
    }
    for (const Mode& mode : modes) {
      const double error = relative_error(Sheet(mode, state.x, state.hangs).forces(), expected);
      rows.push_back(row_of(std::string(state.name) + ": " + mode.name, "force_error", "1", error));
    }
  }
  for (const Mode& mode : modes) {
    progress << "accumulate: equilibrium, " << mode.name << "\n";
    Sheet sheet(mode, rest, true);
    sheet.advance(quick ? 2000 : 8000);
    rows.push_back(row_of(std::string("equilibrium: ") + mode.name, "equilibrium_error", "m",
                          furthest(sheet.positions(), rest)));
  }
  return rows;
}

}  // namespace weft::bench
