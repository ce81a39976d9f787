// weft recall from outside.
#include "cli_support.h"

#include "reference/random.h"

namespace weft::io::test {
namespace {

/// Free points in a box, with or without self-collision.
Json cloud_scene(size_t count, const Json& self_collision) {
  reference::SplitMix random(42);
  Json positions = Json::array();
  for (size_t i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    positions.push_back({x, y, z});
  }
  Json scene = scene_of(Json{{"name", "cloud"},
                             {"mass", 1},
                             {"network", {{"positions", positions}, {"springs", Json::array()}}}});
  scene["self_collision"] = self_collision;
  return scene;
}

Json recall_of(const Json& scene, const std::string& options = "") {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_weft("recall --json " + options + folder.write("s.json", scene.dump()));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return Json::parse(outcome.out);
}

TEST(CliRecall, OfTheCompleteSearchIsOne) {
  const Json scene =
      cloud_scene(20000, {{"method", "complete"}, {"distance", 0.036840315}, {"cell", 0.01}});
  for (const char* options : {"", "--threads 3 ", "--backend omp "}) {
    const Json json = recall_of(scene, options);
    EXPECT_EQ(json["method"], "complete");
    EXPECT_EQ(json["pairs_true"], 40471);
    EXPECT_EQ(json["pairs_found"], 40471);
    EXPECT_EQ(json["pairs_wrong"], 0);
    EXPECT_EQ(json["recall"], 1);
    EXPECT_EQ(json["predicted_recall"], 1);
    EXPECT_GT(json["seconds"], 0);
  }
}

TEST(CliRecall, OfOneGridIsNearItsFormula) {
  Json search{
      {"method", "staggered"}, {"distance", 0.036840315}, {"cell", 0.07368063}, {"grids", 1}};
  const Json json = recall_of(cloud_scene(20000, search));
  EXPECT_EQ(json["method"], "staggered");
  EXPECT_EQ(json["pairs_true"], 40471);
  EXPECT_NEAR(json["predicted_recall"].get<double>(), 0.528019, 1e-6);
  EXPECT_NEAR(json["recall"].get<double>(), 0.5390, 0.025);  // one place of the grid
  EXPECT_DOUBLE_EQ(json["recall"].get<double>(), json["pairs_found"].get<double>() / 40471);
  search["window"] = 2;
  const Json windowed = recall_of(cloud_scene(20000, search));
  EXPECT_TRUE(windowed["predicted_recall"].is_null());
  EXPECT_LT(windowed["recall"], 0.3);
  EXPECT_GT(windowed["recall"], 0.15);
}

TEST(CliRecall, CountsPairsThatSpringsKeepNear) {
  Json scene = falling_scene();  // 3 x 4 vertices, 1/3 m and 1 m apart
  scene["self_collision"] = {{"method", "complete"}, {"distance", 0.34}};
  const Json json = recall_of(scene);
  EXPECT_EQ(json["pairs_true"], 9);
  EXPECT_EQ(json["pairs_found"], 9);
}

TEST(CliRecall, NeedsNoStableStep) {
  Json scene = falling_scene();
  scene["time"]["substeps"] = 1;
  scene["cloths"][0]["stiffness"] = 1e6;
  scene["self_collision"] = {{"method", "complete"}, {"distance", 0.34}};
  EXPECT_EQ(recall_of(scene)["recall"], 1);
}

TEST(CliRecall, OfFarPointsIsOne) {
  Json cloth = network_cloth();
  Json scene = scene_of(cloth);
  scene["self_collision"] = {{"method", "staggered"}, {"distance", 0.01}};
  const Json json = recall_of(scene);
  EXPECT_EQ(json["pairs_true"], 0);
  EXPECT_EQ(json["pairs_found"], 0);
  EXPECT_EQ(json["recall"], 1);
}

TEST(CliRecall, RespectsTheKeysOfCloths) {
  Json scene = cloud_scene(500, {{"method", "complete"}, {"distance", 0.1}});
  scene["cloths"].push_back(scene["cloths"][0]);
  scene["cloths"][1]["name"] = "other";
  const int itself = recall_of(cloud_scene(500, scene["self_collision"]))["pairs_true"];
  const int all = recall_of(scene)["pairs_true"];
  EXPECT_EQ(all, 4 * itself + 500);  // the same points twice
  scene["cloths"][1]["collision"] = {{"itself", false}};
  EXPECT_EQ(recall_of(scene)["pairs_true"], 3 * itself + 500);
  scene["cloths"][1]["collision"] = {{"others", false}};
  EXPECT_EQ(recall_of(scene)["pairs_true"], 2 * itself);
  scene["cloths"][0]["collision"] = {{"layers", 5}};
  scene["cloths"][1]["collision"] = {{"layers", 2}};
  for (const char* key : {"pairs_true", "pairs_found"})
    EXPECT_EQ(recall_of(scene)[key], 2 * itself);
}

TEST(CliRecall, PrintsLinesForPeople) {
  const TemporaryFolder folder;
  const Outcome outcome = run_weft(
      "recall " +
      folder.write("s.json", cloud_scene(300, {{"method", "complete"}, {"distance", 0.1}}).dump()));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_CONTAINS(outcome.out, "method");
  EXPECT_CONTAINS(outcome.out, "recall     100 %\n");
}

TEST(CliRecall, OfAnAbsentBackendIsExitCode4) {
  const TemporaryFolder folder;
  const Json scene = cloud_scene(3, {{"method", "complete"}, {"distance", 0.1}});
  const std::string file = folder.write("s.json", scene.dump());
  expect_failure(run_weft("recall --backend hip " + file), 4, "hip");
}

TEST(CliRecall, RefusesASceneThatSearchesNothing) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("s.json", falling_scene().dump());
  expect_failure(run_weft("recall " + scene), 2, "s.json: $.self_collision: null");
  expect_failure(run_weft("recall --json " + scene), 2, "$.self_collision: null");
  expect_failure(run_weft("recall"), 2, "SCENE is required");
  expect_failure(run_weft("recall --time 1 " + scene), 2, "--time");
  expect_failure(run_weft("recall --threads 0 " + scene), 2, "--threads");
  expect_failure(run_weft("recall missing.json"), 2, "missing.json");
}

}  // namespace
}  // namespace weft::io::test
