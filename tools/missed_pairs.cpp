#include "missed_pairs.h"

#include "output.h"

#include <algorithm>

namespace weft::tools {
namespace {

using Found = std::vector<MissedPairs>;

constexpr const char* otherwise = ", or give \"complete\"";

/// m: of all cloths that meet themselves or others.
double largest_distance(const io::Scene& scene) {
  double largest = 0;
  for (const io::ClothScene& cloth : scene.cloths) {
    if (!cloth.collides_itself && !cloth.collides_others) continue;
    const double own = cloth.collision_distance;
    largest = std::max(largest, own > 0 ? own : scene.self_collision->distance);
  }
  return largest;
}

/// How many distances wide a cell must be for these grids to find all pairs; 0: no width will do. A
/// pair that is shorter than n/k of a cell is parted along each axis by n of k diagonal grids at
/// most; while 3n < k, one holds it.
double cells_needed(const io::SelfCollisionScene& search) {
  if (!search.diagonal) return search.grids == 8 ? 2 : 0;
  const uint32_t steps = (search.grids - 1) / 3;
  return steps > 0 ? double(search.grids) / steps : 0;
}

std::string grids_text(const io::SelfCollisionScene& search) {
  return std::to_string(search.grids) + (search.diagonal ? " diagonal" : " corner") +
         (search.grids == 1 ? " grid" : " grids");
}

void look_at_cell(const io::SelfCollisionScene& search, double distance, Found& found) {
  const double needed = cells_needed(search);
  const std::string meters = figure(distance) + " m";
  const double enough = std::max(needed, search.diagonal ? 4.0 : 2.0) * distance;
  if (search.cell < distance) {
    found.push_back(
        {true, "$.self_collision.cell: " + figure(search.cell) + " m is below the distance, " +
                   meters +
                   " (a pair that is further apart than a cell along an axis shares none "
                   "and is missed) give at least " +
                   figure(enough) + " m" + otherwise});
  }
  if (needed == 0) {
    const char* remedy = search.diagonal ? "give at least 4, in cells of " : "give 8, in cells of ";
    found.push_back({false, "$.self_collision.grids: " + grids_text(search) +
                                " (a pair that a face of each of them parts is missed) " + remedy +
                                figure(enough) + " m" + otherwise});
  } else if (search.cell >= distance && search.cell < needed * distance * (1 - 1e-12)) {
    found.push_back({false, "$.self_collision.cell: " + figure(search.cell) +
                                " m for a distance of " + meters + " (" + grids_text(search) +
                                " may all part a pair) give at "
                                "least " +
                                figure(needed * distance) + " m" + otherwise});
  }
}

}  // namespace

std::vector<MissedPairs> missed_pairs(const io::Scene& scene) {
  Found found;
  if (!scene.self_collision || scene.self_collision->complete) return found;
  const io::SelfCollisionScene& search = *scene.self_collision;
  const double distance = largest_distance(scene);
  if (!(distance > 0)) return found;
  look_at_cell(search, distance, found);
  if (search.window) {
    found.push_back({false, "$.self_collision.window: " + std::to_string(*search.window) +
                                " (in a cell with more particles than that, pairs further apart in "
                                "its order are missed) give null" +
                                otherwise});
  }
  return found;
}

}  // namespace weft::tools
