// Gather or scatter, and the numbers that the ways to add up forces need.
#pragma once

#include "api/records/cloth.h"
#include "plan/cost.h"
#include "step/backend.h"

namespace weft::api {

/// What both ways cost a cloth on a back end.
plan::EvaluationCost cost_of(const ClothRecord&, Precision, const BackendInfo&);
/// Decides for a cloth that has just been made.
void choose_evaluation(const WorldDesc&, const BackendInfo&, ClothRecord&);

/// A power of two at or above `value`, which is not negative and finite; 1 for 0.
double power_of_two_above(double value);

/// fixed64: forces are counted in units of 1/scale N, and a spring may pull up to `limit` N, at
/// least 4096 times what it pulls at twice its length. The sum of a vertex then stays below 2^62.
struct FixedRange {
  double scale, limit;
};
FixedRange fixed_range(const ClothRecord&);
/// float16: what forces are multiplied by: all springs of a vertex fit at twice their length.
double half_scale(const ClothRecord&);

}  // namespace weft::api
