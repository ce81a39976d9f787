#include "io/recall.h"

#include "io/predicted_recall.h"

#include <algorithm>
#include <cmath>

namespace weft::io {
namespace {

/// Mean squares may be off by the border of a cloud, and by chance.
constexpr double border = 0.12, deviations = 5;

struct Moments {
  uint64_t pairs = 0;
  double3 square{0, 0, 0};

  void add(double3 d) {
    ++pairs;
    square = {square.x + d.x * d.x, square.y + d.y * d.y, square.z + d.z * d.z};
  }
  bool is_cloud(double distance) const {
    if (pairs == 0) return true;
    const double n = double(pairs), fifth = n * distance * distance / 5;
    const double off = (border + deviations / std::sqrt(n)) * fifth;
    return std::abs(square.x - fifth) <= off && std::abs(square.y - fifth) <= off &&
           std::abs(square.z - fifth) <= off;
  }
};

bool have_distance(const std::vector<MeetingCloth>& cloths, double distance) {
  return std::all_of(cloths.begin(), cloths.end(),
                     [&](const MeetingCloth& cloth) { return cloth.distance == distance; });
}

bool is_near(const std::vector<MeetingCloth>& cloths, const MeetingPair& pair) {
  const bool same = pair.cloth_a == pair.cloth_b;
  if (pair.cloth_b >= cloths.size() || pair.cloth_a > pair.cloth_b) return false;
  const MeetingCloth &a = cloths[pair.cloth_a], &b = cloths[pair.cloth_b];
  if (pair.vertex_a >= a.positions.size() || pair.vertex_b >= b.positions.size()) return false;
  if (same && pair.vertex_a >= pair.vertex_b) return false;
  return are_nearer(a.positions[pair.vertex_a], b.positions[pair.vertex_b],
                    meeting_distance(a, b, same));
}

}  // namespace

Recall compare_pairs(const std::vector<ClothId>& ids, const std::vector<MeetingCloth>& cloths,
                     View<NearPair> found) {
  const auto index_of = [&](ClothId id) {
    return uint32_t(std::find(ids.begin(), ids.end(), id) - ids.begin());
  };
  std::vector<MeetingPair> pairs;
  pairs.reserve(found.count);
  for (uint32_t i = 0; i < found.count; ++i) {
    const NearPair& pair = found[i];
    pairs.push_back({index_of(pair.cloth_a), pair.vertex_a, index_of(pair.cloth_b), pair.vertex_b});
  }
  if (!std::is_sorted(pairs.begin(), pairs.end())) std::sort(pairs.begin(), pairs.end());
  Recall recall;
  recall.pairs_true = count_near_pairs(cloths);
  for (size_t i = 0; i < pairs.size(); ++i) {
    const bool right = is_near(cloths, pairs[i]) && (i == 0 || pairs[i - 1] != pairs[i]);
    recall.pairs_found += right;
    recall.pairs_wrong += !right;
  }
  return recall;
}

ExpectedRecall expect_recall(const SelfCollisionDesc& desc,
                             const std::vector<MeetingCloth>& cloths) {
  if (desc.search == PairSearch::complete) return {1.0, 1.0};
  const std::optional<double> predicted = predicted_recall(desc);
  if (!predicted) return {};
  PairChance chance({desc.cell, desc.grids, desc.shifts});
  Moments moments;
  double sum = 0;
  each_near_pair(cloths, [&](const MeetingPair& pair) {
    const double3 a = cloths[pair.cloth_a].positions[pair.vertex_a];
    const double3 b = cloths[pair.cloth_b].positions[pair.vertex_b];
    const double3 d{a.x - b.x, a.y - b.y, a.z - b.z};
    moments.add(d);
    sum += chance(d);
  });
  ExpectedRecall expected;
  expected.of_pairs = moments.pairs > 0 ? sum / double(moments.pairs) : 1;
  if (have_distance(cloths, desc.distance) && moments.is_cloud(desc.distance)) {
    expected.of_cloud = predicted;
  }
  return expected;
}

}  // namespace weft::io
