#include "plan/cost.h"

#include <gtest/gtest.h>

namespace weft::plan {
namespace {

EvaluationShape shape_of(bool grid, uint64_t edges, uint64_t entries) {
  return {grid, edges, entries};
}

TEST(Cost, GrowsWithSpringsAndPadding) {
  const EvaluationPrices price{0.5, 1, 2, 3};
  const EvaluationCost mesh = evaluation_cost(shape_of(false, 100, 200), price);
  EXPECT_DOUBLE_EQ(mesh.gather, 200);
  EXPECT_DOUBLE_EQ(mesh.scatter, 800);
  const EvaluationCost padded = evaluation_cost(shape_of(false, 100, 300), price);
  EXPECT_DOUBLE_EQ(padded.gather, 300);
  EXPECT_DOUBLE_EQ(padded.scatter, 1100);
  EXPECT_DOUBLE_EQ(evaluation_cost(shape_of(true, 100, 200), price).gather, 100);
}

TEST(Cost, PrefersScatterWhereASpringIsDear) {
  const EvaluationCost cost = evaluation_cost(shape_of(false, 100, 200), {0.5, 9, 10, 1});
  EXPECT_LT(cost.scatter, cost.gather);
}

TEST(Cost, KnowsEveryInstructionLevelAndGpus) {
  for (const char* isa : {"v2", "v3", "v4", "-"}) {
    for (const Precision p : {Precision::float32, Precision::float64}) {
      const EvaluationPrices price = prices_of(isa, p);
      EXPECT_GT(price.mesh_spring, 0) << isa;
      EXPECT_GT(price.edge, 0) << isa;
      EXPECT_GT(price.incident, 0) << isa;
      EXPECT_LE(price.grid_spring, price.mesh_spring) << isa;
    }
  }
}

}  // namespace
}  // namespace weft::plan
