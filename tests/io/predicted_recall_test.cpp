// What staggered grids find, against formulas, grids at random places and published figures.
#include "io/predicted_recall.h"

#include "reference/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace weft::io {
namespace {

using reference::SplitMix;

double chance_of_pair(const StaggeredGrids& grids, double3 offset) {
  return PairChance(grids)(offset);
}

constexpr GridShifts corner = GridShifts::corner, diagonal = GridShifts::diagonal;

TEST(PredictedRecall, OfOneGridIsTheKnownPolynomial) {
  const double expected[] = {0.217183, 0.528019, 0.742002, 0.865266};
  for (int i = 0; i < 4; ++i) {
    for (const GridShifts shifts : {corner, diagonal}) {
      EXPECT_NEAR(recall_of_uniform_points({double(1 << i), 1, shifts}, 1), expected[i], 5e-7);
    }
  }
}

TEST(PredictedRecall, IsContinuousWhereThePolynomialEnds) {
  EXPECT_NEAR(recall_of_uniform_points({1, 1, corner}, 1),
              recall_of_uniform_points({1, 1, corner}, 1.0001), 3e-4);
}

// Measured on 20,000 uniform points from one place of the grids, hence the tolerance.
TEST(PredictedRecall, OfSeveralGridsIsNearTheMeasuredOnes) {
  struct Row {
    double cell, two, four, eight, four_diagonal;
  };
  for (const Row& row : {Row{1, .4031, .6006, .6775, .6230}, Row{2, .8416, .9818, 1, .9880},
                         Row{4, .9606, .9981, 1, 1}}) {
    EXPECT_NEAR(recall_of_uniform_points({row.cell, 2, corner}, 1), row.two, 0.015);
    EXPECT_NEAR(recall_of_uniform_points({row.cell, 4, corner}, 1), row.four, 0.015);
    EXPECT_NEAR(recall_of_uniform_points({row.cell, 8, corner}, 1), row.eight, 0.015);
    EXPECT_NEAR(recall_of_uniform_points({row.cell, 4, diagonal}, 1), row.four_diagonal, 0.015);
  }
}

TEST(PredictedRecall, IsCompleteWhereTheGridsAre) {
  SplitMix random(1);
  for (int i = 0; i < 2000; ++i) {
    const reference::Vec d = random.noise(1);
    const double most = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const auto of = [&](uint32_t k, GridShifts shifts, double reach) {
      const double s = 0.999999 * reach / most;
      return chance_of_pair({1, k, shifts}, {s * d.x, s * d.y, s * d.z});
    };
    EXPECT_NEAR(of(8, corner, 0.5), 1, 1e-12);
    EXPECT_NEAR(of(4, diagonal, 0.25), 1, 1e-12);
    EXPECT_NEAR(of(7, diagonal, 2.0 / 7), 1, 1e-12);
    EXPECT_NEAR(of(10, diagonal, 0.3), 1, 1e-12);
    EXPECT_LT(of(8, corner, 3), 1);
  }
  // Just beyond, along a diagonal of space, pairs are lost.
  EXPECT_LT(chance_of_pair({1, 8, corner}, {.51, .51, .51}), 1);
  EXPECT_LT(chance_of_pair({1, 4, diagonal}, {.26, .26, .26}), 1);
  EXPECT_LT(chance_of_pair({1, 64, diagonal}, {.35, .35, .35}), 1);
}

/// Whether one of the grids, from `begin`, has both points in one cell.
bool found(const StaggeredGrids& g, const double (&a)[3], const double (&b)[3],
           const double (&begin)[3]) {
  constexpr int corners[][8] = {{0}, {0, 7}, {}, {0, 6, 5, 3},
                                {},  {},     {}, {0, 1, 2, 3, 4, 5, 6, 7}};
  for (uint32_t k = 0; k < g.grids; ++k) {
    bool same = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double shift = g.shifts == diagonal
                               ? double(k) / g.grids * g.cell
                               : (corners[g.grids - 1][k] >> axis & 1) * 0.5 * g.cell;
      same &= std::floor((a[axis] - begin[axis] - shift) / g.cell) ==
              std::floor((b[axis] - begin[axis] - shift) / g.cell);
    }
    if (same) return true;
  }
  return false;
}

TEST(PredictedRecall, OfAPairIsThatOfGridsAtRandomPlaces) {
  const StaggeredGrids all[] = {{1, 1, corner},   {1, 2, corner},   {1, 4, corner},
                                {1, 8, corner},   {1, 2, diagonal}, {1, 3, diagonal},
                                {1, 4, diagonal}, {1, 8, diagonal}, {0.7, 5, diagonal}};
  const double3 offsets[] = {{.1, .2, .3}, {.4, -.4, .4}, {.6, .1, -.2},
                             {0, 0, .9},   {.5, .5, 0},   {.7, .6, .5}};
  constexpr int places = 20000;
  SplitMix random(11);
  for (const StaggeredGrids& g : all) {
    for (const double3& d : offsets) {
      int count = 0;
      for (int i = 0; i < places; ++i) {
        const double a[] = {3, -5, 0.2}, b[] = {3 + d.x, -5 + d.y, 0.2 + d.z};
        const double begin[] = {g.cell * random.uniform(), g.cell * random.uniform(),
                                g.cell * random.uniform()};
        count += found(g, a, b, begin);
      }
      EXPECT_NEAR(chance_of_pair(g, d), double(count) / places, 0.016)  // 4.5 sigma
          << g.grids << " grids, offset " << d.x << ' ' << d.y << ' ' << d.z;
    }
  }
}

TEST(PredictedRecall, GrowsWithGridsAndCells) {
  for (const GridShifts shifts : {corner, diagonal}) {
    for (const double cell : {0.5, 1.0, 2.0, 3.0}) {
      const auto of = [&](uint32_t k, double h) {
        return recall_of_uniform_points({h, k, shifts}, 1);
      };
      EXPECT_LT(of(1, cell), of(2, cell));
      EXPECT_LT(of(2, cell), of(4, cell));
      EXPECT_LE(of(4, cell), of(8, cell) + 1e-12);
      EXPECT_LT(of(2, cell), of(2, 1.1 * cell));
    }
  }
}

TEST(PredictedRecall, OfAWorldsSearch) {
  SelfCollisionDesc desc;
  EXPECT_EQ(predicted_recall(desc), 1);
  desc.search = PairSearch::staggered;
  EXPECT_NEAR(predicted_recall(desc).value(), 1, 1e-12);  // 8 corner grids, twice the distance
  desc.cell = desc.distance;
  desc.grids = 1;
  EXPECT_NEAR(predicted_recall(desc).value(), 0.217183, 5e-7);
  desc.window = 4;
  EXPECT_FALSE(predicted_recall(desc).has_value());
}

}  // namespace
}  // namespace weft::io
