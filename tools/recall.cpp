// weft recall: the pairs that self-collision finds at the start, against all that there are.
#include "commands.h"

#include "arguments.h"
#include "output.h"

#include "io/build.h"
#include "io/error.h"
#include "io/recall.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <optional>

namespace weft::tools {
namespace {

using Json = nlohmann::ordered_json;

/// The cloths at their positions as the solver has them.
std::vector<io::MeetingCloth> meeting_cloths(const io::Scene& scene, io::RunningScene& made,
                                             double distance) {
  std::vector<io::MeetingCloth> cloths(made.cloths.size());
  for (size_t i = 0; i < cloths.size(); ++i) {
    const io::ClothScene& given = scene.cloths[i];
    io::MeetingCloth& cloth = cloths[i];
    cloth.positions.resize(made.fabrics[i].vertex_count());
    made.require(made.world.read_positions(made.cloths[i], cloth.positions.data()), scene.file);
    cloth.distance = given.collision_distance > 0 ? given.collision_distance : distance;
    cloth.itself = given.collides_itself != 0;
    cloth.others = given.collides_others != 0;
    cloth.layers = given.collision_layers;
  }
  return cloths;
}

struct Measured {
  io::Recall pairs;
  io::ExpectedRecall expected;
  double seconds;  ///< of the search
};

Measured measure(const io::Scene& scene, io::RunningScene& made, const SelfCollisionDesc& search) {
  // Reading builds the world, which is no part of the search.
  const std::vector<io::MeetingCloth> cloths = meeting_cloths(scene, made, search.distance);
  const auto begin = std::chrono::steady_clock::now();
  const auto found = made.world.near_pairs(true);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  made.require(found.status(), scene.file + ": $.self_collision");
  return {io::compare_pairs(made.cloths, cloths, *found), io::expect_recall(search, cloths),
          time.count()};
}

std::string method_of(const SelfCollisionDesc& search) {
  return search.search == PairSearch::complete ? "complete" : "staggered";
}

std::string percent(const std::optional<double>& share, const char* otherwise) {
  return share ? figure(100 * *share) + " %" : otherwise;
}

std::string description_of(const SelfCollisionDesc& search) {
  if (search.search == PairSearch::complete) return method_of(search);
  return method_of(search) + ", " + std::to_string(search.grids) +
         (search.shifts == GridShifts::corner ? " corner" : " diagonal") +
         (search.grids == 1 ? " grid of cells of " : " grids of cells of ") + figure(search.cell) +
         " m, " + (search.window > 0 ? "window " + std::to_string(search.window) : "no window");
}

void print_human(const io::Scene& scene, const SelfCollisionDesc& search, const Measured& m) {
  print_lines({{"scene", scene.file},
               {"method", description_of(search)},
               {"pairs", std::to_string(m.pairs.pairs_found) + " found of " +
                             std::to_string(m.pairs.pairs_true) + " nearer than their distance"},
               {"recall", percent(m.pairs.recall(), "")},
               {"predicted", percent(m.expected.of_cloud, "no formula applies")},
               {"expected", percent(m.expected.of_pairs, "no formula applies")},
               {"time", seconds_text(m.seconds) + " of the search"}});
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const SelfCollisionDesc& search, const Measured& m) {
  return {{"method", method_of(search)},
          {"pairs_true", m.pairs.pairs_true},
          {"pairs_found", m.pairs.pairs_found},
          {"pairs_wrong", m.pairs.pairs_wrong},
          {"recall", m.pairs.recall()},
          {"predicted_recall", json_of(m.expected.of_cloud)},
          {"expected_recall", json_of(m.expected.of_pairs)},
          {"seconds", m.seconds}};
}

}  // namespace

int recall_command(const CommonOptions& options) {
  const ContextDesc desc = context_desc(options);
  const io::Scene scene = io::read_scene(options.scene);
  if (!scene.self_collision) {
    throw io::InputError(scene.file +
                         ": $.self_collision: null (no cloth of this scene meets itself, so "
                         "there is no search to judge) give its method and distance");
  }
  const SelfCollisionDesc search = io::self_collision_desc(*scene.self_collision);
  io::RunningScene made = io::build(scene, desc);
  const Measured measured = measure(scene, made, search);
  if (measured.pairs.pairs_wrong > 0) {
    print_message("warning: " + scene.file + ": " + std::to_string(measured.pairs.pairs_wrong) +
                  " pairs that were found are not nearer than their distance (the search is at "
                  "fault) report it");
  }
  if (options.json)
    print_json(json_of(search, measured));
  else
    print_human(scene, search, measured);
  return done;
}

}  // namespace weft::tools
