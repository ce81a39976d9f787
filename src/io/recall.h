// How many of the near pairs a world's search finds.
#pragma once

#include "weft/world.hpp"

#include "io/exact_pairs.h"

#include <optional>
#include <vector>

namespace weft::io {

struct Recall {
  uint64_t pairs_true = 0;   ///< nearer than their distance, by the exact search
  uint64_t pairs_found = 0;  ///< of these
  uint64_t pairs_wrong = 0;  ///< found, but not near, or found twice: a fault of the search
  /// 1 where there are none.
  double recall() const { return pairs_true > 0 ? double(pairs_found) / double(pairs_true) : 1; }
};

/// Compares what a world found with the exact search. Of each cloth its id and its points.
Recall compare_pairs(const std::vector<ClothId>&, const std::vector<MeetingCloth>&,
                     View<NearPair> found);

/// What these pairs make one expect of staggered grids without a window at a random place.
struct ExpectedRecall {
  /// The mean over the pairs there are; none with a window.
  std::optional<double> of_pairs;
  /// Of a uniform cloud of points (io/predicted_recall.h). None with a window, where cloths have
  /// distances of their own, and where the pairs do not lie in all directions and at all distances
  /// alike, as they do in a cloud: their mean square along some axis is not a fifth of distance^2.
  std::optional<double> of_cloud;
};
/// 1 of PairSearch::complete.
ExpectedRecall expect_recall(const SelfCollisionDesc&, const std::vector<MeetingCloth>&);

}  // namespace weft::io
