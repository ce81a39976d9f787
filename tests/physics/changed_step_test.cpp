// Damping along springs follows its recurrence when the step changes, however the springs are
// evaluated: velocities are the displacements of the step before by the length of that step.
#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

/// x' = x + d', d' = r d + h f/m with f from positions and d/dt_before; d = v dt at the start.
class Uneven {
 public:
  Uneven(reference::System system, double first_dt)
      : system_(std::move(system)), before_(first_dt), x_(system_.positions) {
    for (const Vec v : system_.velocities) d_.push_back(first_dt * v);
    d_.resize(x_.size());
    for (const uint32_t pin : system_.pins) d_[pin] = {};
  }
  void step(double dt) {
    std::vector<Vec> f(x_.size()), v(x_.size());
    for (size_t i = 0; i < x_.size(); ++i) v[i] = (1 / before_) * d_[i];
    reference::add_spring_forces(system_.springs, x_, f);
    reference::add_spring_damping(system_.springs, system_.spring_damping, x_, v, f);
    for (const uint32_t pin : system_.pins) f[pin] = {};
    for (size_t i = 0; i < x_.size(); ++i) {
      d_[i] = (dt / before_) * d_[i] + (dt * (dt + before_) / 2 / system_.masses[i]) * f[i];
    }
    for (size_t i = 0; i < x_.size(); ++i) x_[i] += d_[i];
    before_ = dt;
  }
  const std::vector<Vec>& positions() const { return x_; }

 private:
  reference::System system_;
  double before_;
  std::vector<Vec> x_, d_;
};

struct Way {
  const char* name;
  weft::Precision precision;
  weft::Form form;
  bool network;
  weft::Evaluation evaluation;
  weft::Accumulate accumulate = weft::Accumulate::native;
};
void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

class ChangedStep : public testing::TestWithParam<Way> {
 protected:
  weft::WorldDesc desc() const {
    weft::WorldDesc desc = plain_world(GetParam().precision, weft::Start::lagged);
    desc.form = GetParam().form;
    desc.evaluation = GetParam().evaluation;
    desc.accumulate = GetParam().accumulate;
    desc.deterministic = desc.accumulate != weft::Accumulate::atomic;
    return desc;
  }
  void follow(TestWorld& test, weft::ClothId id, const reference::System& system) {
    // Powers of two apart and not, shorter and longer.
    const double steps[] = {3e-3, 3e-3, 0.75e-3, 1e-3, 4e-3, 1e-3, 4.2e-3, 4e-3, 2e-3, 3e-3};
    Uneven expected(system, steps[0]);
    double furthest = 0;
    for (const double dt : steps) {
      test.step(dt);
      expected.step(dt);
      const std::vector<Vec> x = test.positions(id);
      const bool whole = GetParam().accumulate == weft::Accumulate::fixed64;
      const double within = GetParam().precision == weft::Precision::float32 ? 1e-5
                            : whole                                          ? 1e-7
                                                                             : 1e-11;
      for (size_t i = 0; i < x.size(); ++i) {
        expect_near(x[i], expected.positions()[i], within);
        furthest = std::max(furthest, length(x[i] - system.positions[i]));
      }
    }
    EXPECT_GT(furthest, 1e-2);
  }
};

std::vector<Vec> noise(size_t count, double width) {
  reference::SplitMix random(17);
  std::vector<Vec> v;
  for (size_t i = 0; i < count; ++i) v.push_back(random.noise(width));
  return v;
}

TEST_P(ChangedStep, KeepsTheRecurrenceOfADampedSheet) {
  Sheet sheet;
  sheet.rows = 6;
  sheet.columns = 7;
  sheet.stiffness = 20;
  sheet.noise = 0.02;
  sheet.single = true;
  sheet.pins = {3};
  reference::System system = sheet.system();
  system.spring_damping = 0.15;
  system.velocities = noise(sheet.count(), 2);
  const std::vector<weft::double3> v = to_weft(system.velocities);
  weft::ClothDesc cloth;
  cloth.spring_damping = system.spring_damping;
  cloth.velocities = v;
  TestWorld test(desc());
  const weft::ClothId id =
      GetParam().network ? sheet.add_network_to(test, cloth) : sheet.add_to(test, cloth);
  follow(test, id, system);
}

TEST_P(ChangedStep, KeepsTheRecurrenceOfADampedHub) {
  if (!GetParam().network) return;
  NetworkParts hub;
  hub.positions = {{0, 0, 0}};
  hub.masses.assign(201, 0.01);
  hub.masses[0] = 0.5;
  for (uint32_t i = 1; i <= 200; ++i) {
    const Vec out = noise(i, 1).back() + Vec{1, 0.5, 0};
    hub.positions.push_back(reference::through_float(out));
    hub.springs.push_back({0, i, 2, length(hub.positions.back())});
  }
  hub.velocities = noise(201, 3);
  hub.velocities[0] = {4, -3, 2};
  reference::System system;
  system.positions = hub.positions;
  system.velocities = hub.velocities;
  system.masses = hub.masses;
  for (const weft::Spring& s : hub.springs) system.springs.push_back({s.a, s.b, 2, s.rest_length});
  system.spring_damping = 0.1;
  weft::ClothDesc cloth;
  cloth.spring_damping = system.spring_damping;
  TestWorld test(desc());
  follow(test, add_network(test, hub, cloth), system);
}

constexpr auto f32 = weft::Precision::float32, f64 = weft::Precision::float64;
constexpr auto summed = weft::Form::summed, position = weft::Form::position;
constexpr auto gather = weft::Evaluation::gather, scatter = weft::Evaluation::scatter;
INSTANTIATE_TEST_SUITE_P(
    Ways, ChangedStep,
    testing::Values(Way{"grid", f64, summed, false, gather},
                    Way{"grid_position", f64, position, false, gather},
                    Way{"grid_single", f32, summed, false, gather},
                    Way{"network", f64, summed, true, gather},
                    Way{"network_position", f64, position, true, gather},
                    Way{"network_single", f32, summed, true, gather},
                    Way{"scattered_grid", f64, summed, false, scatter},
                    Way{"scattered", f64, summed, true, scatter},
                    Way{"scattered_position", f64, position, true, scatter},
                    Way{"fixed64", f64, summed, true, scatter, weft::Accumulate::fixed64},
                    Way{"atomic", f64, position, true, scatter, weft::Accumulate::atomic}),
    [](const testing::TestParamInfo<Way>& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace weft_tests
