// Scenes with self-collision, from outside: what check says of settings and of pairs that never
// touch, and what a run reports.
#include "cli_support.h"

namespace weft::io::test {
namespace {

struct SelfCollision : ::testing::Test {
  TemporaryFolder folder;
  std::string scene(const Json& json) const { return folder.write("s.json", json.dump()); }
  Json findings(const Json& json) const {
    const Outcome outcome = run_weft("check --json " + scene(json));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out)["diagnostics"];
  }
  Json report(const Json& json) const {
    const Outcome outcome = run_weft("run --json " + scene(json));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

/// A sheet whose columns are 1/3 m apart, and rows 1 m.
Json sheet_with(const char* self_collision) {
  Json json = falling_scene();
  json["self_collision"] = Json::parse(self_collision);
  return json;
}

TEST_F(SelfCollision, PairsThatRestTooNearAreSaidAndCounted) {
  Json json = sheet_with(R"({"method": "complete", "distance": 0.5})");
  const Json found = findings(json);
  ASSERT_EQ(found.size(), 1u) << found;
  EXPECT_EQ(found[0]["severity"], "info");
  EXPECT_EQ(found[0]["cloth"], 0);
  EXPECT_CONTAINS(found[0]["text"].get<std::string>(), "9 pairs of vertices are nearer");
  EXPECT_CONTAINS(found[0]["text"].get<std::string>(), "0.5 m");
  EXPECT_CONTAINS(run_weft("check " + scene(json)).out, "cloth 'sheet': 9 pairs of vertices");
  EXPECT_EQ(report(json)["pairs_excluded"], 9);
  EXPECT_EQ(report(json)["contacts"], 0);
  const Outcome run = run_weft("run " + scene(json));
  EXPECT_CONTAINS(run.out, "0 pairs touch at the end, 9 are too near at rest");
  EXPECT_EQ(run.err, "") << "it is no warning";

  json["cloths"][0]["collision"] = {{"distance", 1.2}};
  EXPECT_EQ(report(json)["pairs_excluded"], (9 + 6 + 3) + 2 * (4 + 6));
  json["cloths"][0]["collision"]["itself"] = false;
  EXPECT_EQ(report(json)["pairs_excluded"], 0);
  EXPECT_TRUE(findings(json).empty());
  json.erase("self_collision");
  EXPECT_EQ(report(json)["pairs_excluded"], 0);
  EXPECT_EQ(report(json)["contacts"], 0);
}

TEST_F(SelfCollision, SettingsThatMissPairsAreSaidWithARemedy) {
  struct Case {
    const char* settings;
    const char* severity;  ///< empty: nothing is said
    const char* text;
  };
  const Case cases[] = {
      {R"({})", "", ""},
      {R"({"distance": 0.01, "cell": 0.0199})", "info", "give at least 0.02 m"},
      {R"({"cell": 0.005})", "warning", "$.self_collision.cell: 0.005 m is below the distance"},
      {R"({"grids": 4})", "info", "$.self_collision.grids: 4 corner grids"},
      {R"({"grids": 1})", "info", "give 8, in cells of 0.02 m"},
      {R"({"window": 5})", "info", "$.self_collision.window: 5"},
      {R"({"shifts": "diagonal", "grids": 3})", "info", "give at least 4, in cells of 0.04 m"},
      {R"({"shifts": "diagonal", "grids": 4, "cell": 0.04})", "", ""},
      {R"({"shifts": "diagonal", "grids": 4, "cell": 0.039})", "info", "give at least 0.04 m"},
      {R"({"shifts": "diagonal", "grids": 7, "cell": 0.035})", "", ""},
      {R"({"shifts": "diagonal", "grids": 7, "cell": 0.034})", "info", "give at least 0.035 m"},
      {R"({"shifts": "diagonal", "grids": 6, "cell": 0.059})", "info", "give at least 0.06 m"},
      {R"({"method": "complete", "cell": 0.001, "grids": 1, "window": 1})", "", ""}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.settings);
    const Json json = sheet_with(c.settings);
    const Json found = findings(json);
    EXPECT_EQ(run_weft("run " + scene(json)).code, 0) << "it is allowed";
    if (!*c.severity) {
      EXPECT_TRUE(found.empty()) << found;
      continue;
    }
    ASSERT_EQ(found.size(), 1u) << found;
    EXPECT_EQ(found[0]["severity"], c.severity);
    EXPECT_TRUE(found[0]["cloth"].is_null());
    EXPECT_CONTAINS(found[0]["text"].get<std::string>(), c.text);
    EXPECT_CONTAINS(found[0]["text"].get<std::string>(), "or give \"complete\"");
  }
}

TEST_F(SelfCollision, TheLargestDistanceOfTheClothsCounts) {
  Json json = sheet_with("{}");
  json["cloths"].push_back(network_cloth());
  json["cloths"][1]["collision"] = {{"distance", 0.05}};
  ASSERT_EQ(findings(json).size(), 1u);
  EXPECT_CONTAINS(findings(json)[0]["text"].get<std::string>(), "below the distance, 0.05 m");
  json["cloths"][1]["collision"]["itself"] = false;
  EXPECT_EQ(findings(json).size(), 1u) << "it meets the sheet";
  json["cloths"][1]["collision"]["others"] = false;
  EXPECT_TRUE(findings(json).empty());
}

TEST_F(SelfCollision, BadSettingsAreRefusedByNameAndWriteNothing) {
  for (const char* command : {"run ", "check ", "plan "}) {
    const Json json = sheet_with(R"({"distance": 0})");
    expect_failure(run_weft(command + scene(json)), 2, "s.json: $.self_collision.distance: 0");
  }
  const Json json = sheet_with(R"({"grids": 3})");
  expect_failure(run_weft("run --final " + (folder / "f.csv") + " " + scene(json)), 2,
                 "$.self_collision.grids: 3");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST_F(SelfCollision, LayersKeepACollidersClothsApart) {
  Json json = falling_scene();
  json["colliders"] = Json::parse(R"([{"plane": {"normal": [0,1,0], "offset": 0}, "layers": 2}])");
  json["cloths"].push_back(json["cloths"][0]);
  json["cloths"][0]["collision"] = {{"layers", 1}};
  const Outcome outcome = run_weft("run --final " + (folder / "f.csv") + " " + scene(json));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  double lowest[2] = {0, 0};
  std::istringstream csv(read_text(folder / "f.csv"));
  std::string line;
  std::getline(csv, line);
  while (std::getline(csv, line)) {
    size_t cloth = 0;
    double y = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%zu,%*d,%*f,%lf", &cloth, &y), 2);
    lowest[cloth] = std::min(lowest[cloth], y);
  }
  EXPECT_NEAR(lowest[0], -9.81 * 0.1 * 0.1 / 2, 1e-9) << "it falls freely";
  EXPECT_NEAR(lowest[1], 0, 1e-9);
}

}  // namespace
}  // namespace weft::io::test
