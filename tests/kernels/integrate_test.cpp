#include "kernels/integrate.h"

#include <gtest/gtest.h>

namespace weft {
using namespace WEFT_BACKEND_NS;

namespace {
StepParams<double> step_of(double dt, double before) {
  StepParams<double> s{};
  s.dt = dt;
  s.ratio = dt / before;
  s.a_factor = 0.5 * dt * (dt + before);
  return s;
}
}  // namespace

TEST(Integrate, NullDragChangesNoBit) {
  const auto step = step_of(0.01, 0.013);
  const Vec3<double> d{0.1234, -0.05, 3e-5}, a{1.7, -9.81, 0.003};
  const auto none = next_displacement(d, a, step);
  for (const auto& with :
       {next_displacement_lagged(d, a, 0.0, step), next_displacement_central(d, a, 0.0, step)}) {
    EXPECT_EQ(with.x, none.x);
    EXPECT_EQ(with.y, none.y);
    EXPECT_EQ(with.z, none.z);
  }
}

TEST(Integrate, PositionFormAtConstantStepIsThePapersFormula) {
  const auto step = step_of(0.01, 0.01);
  const Vec3<double> x{1.1, 0.3, -2.7}, before{1.09, 0.31, -2.5}, a{3, -9.81, 0.1};
  const auto next = next_position(x, before, a, step);
  EXPECT_EQ(next.x, (2 * x.x - before.x) + 0.01 * 0.01 * a.x);
  EXPECT_EQ(next.y, (2 * x.y - before.y) + 0.01 * 0.01 * a.y);
}

TEST(Integrate, TaylorStartMakesTheFirstStepSecondOrder) {
  const double dt = 0.01, g = 0.3, v0 = 2.0, a = -5.0;
  const auto step = step_of(dt, dt);
  const auto d0 = taylor_start(Vec3<double>{v0 * dt, 0, 0}, Vec3<double>{a, 0, 0}, g, step);
  // a0 includes drag: a - (g/dt) v0.
  const double expected = v0 * dt + 0.5 * dt * dt * (a - g / dt * v0);
  EXPECT_NEAR(next_displacement_central(d0, Vec3<double>{a, 0, 0}, g, step).x, expected, 1e-15);
}

}  // namespace weft
