// Runs with mesh colliders, wind and sleep.
#include "cli_support.h"

#include <sstream>

namespace weft::io::test {
namespace {

struct Surroundings : ::testing::Test {
  TemporaryFolder folder;
  std::string scene(const Json& json) const { return folder.write("s.json", json.dump()); }
  Json report(const Json& json) const {
    const Outcome outcome = run_weft("run --json " + scene(json));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out);
  }
  /// Least y of the final state.
  double lowest(const Json& json) const {
    const Outcome outcome = run_weft("run --final " + (folder / "f.csv") + " " + scene(json));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream csv(read_text(folder / "f.csv"));
    std::string line;
    std::getline(csv, line);
    double least = 1e300;
    for (double y = 0; std::getline(csv, line); least = std::min(least, y)) {
      EXPECT_EQ(std::sscanf(line.c_str(), "%*d,%*d,%*f,%lf", &y), 1);
    }
    return least;
  }
};

// A square of 1 m in the plane z = 0.
const char* const square =
    "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3\nf 1 3 4\n";

Json over_floor() {
  Json json = falling_scene();
  json["colliders"] = Json::parse(R"([{ "mesh": { "file": "square.obj", "thickness": 0.004,
    "transform": { "scale": 10, "rotate": { "axis": [1,0,0], "degrees": 90 },
                   "translate": [0,-0.01,0] } } }])");
  return json;
}

Json still_scene() {
  Json json = falling_scene();
  json["gravity"] = {0, 0, 0};
  return json;
}

TEST_F(Surroundings, AMeshHoldsClothAtItsThickness) {
  folder.write("square.obj", square);
  const Json json = over_floor();
  EXPECT_NEAR(lowest(json), -0.006, 1e-4) << "without it, 0.1 s of free fall end at -0.049";
  EXPECT_EQ(run_weft("check " + scene(json)).code, 0);
  EXPECT_EQ(run_weft("plan " + scene(json)).code, 0);
}

TEST_F(Surroundings, TheScaleOfAMeshIsNotThatOfItsThickness) {
  folder.write("square.obj", square);
  Json json = over_floor();
  json["colliders"][0]["mesh"]["transform"]["scale"] = 40;
  EXPECT_NEAR(lowest(json), -0.006, 1e-4);
}

TEST_F(Surroundings, AnOpenMeshIsNotClosed) {
  folder.write("square.obj", square);
  Json json = over_floor();
  json["colliders"][0]["mesh"]["closed"] = true;
  for (const char* command : {"run ", "check "}) {
    expect_failure(run_weft(command + scene(json)), 2, "s.json: $.colliders[0]: ");
  }
}

TEST_F(Surroundings, WindMovesASheet) {
  EXPECT_EQ(report(still_scene())["momentum"][2], 0);
  Json json = still_scene();
  json["wind"] = {{"velocity", {0, 0, 2}}, {"tangential", 0}};
  // A rigid plate of 2 m^2 and 1 kg: w = V q/(1 + q), q = V t rho A/(2 m); the sheet bends a
  // little.
  const double q = 2 * 0.1 * 1.225;
  EXPECT_NEAR(report(json)["momentum"][2].get<double>(), 2 * q / (1 + q), 0.04);
  json["wind"]["air_density"] = 0;
  EXPECT_EQ(report(json)["momentum"][2], 0);
}

TEST_F(Surroundings, WindThatMissesANetworkIsADiagnostic) {
  const std::string text =
      "cloth \"net\" is a network (it has no triangles for wind to act on) use a grid or a mesh, "
      "or leave out the wind";
  Json json = still_scene();
  json["cloths"].push_back(network_cloth());
  json["wind"] = {{"velocity", {0, 0, 2}}};
  const Json check = Json::parse(run_weft("check --json " + scene(json)).out);
  ASSERT_EQ(check["diagnostics"].size(), 1u) << check;
  EXPECT_EQ(check["diagnostics"][0]["severity"], "warning");
  EXPECT_EQ(check["diagnostics"][0]["cloth"], 1);
  EXPECT_CONTAINS(check["diagnostics"][0]["text"].get<std::string>(), text);
  EXPECT_CONTAINS(run_weft("check " + scene(json)).out, text);
  const Outcome run = run_weft("run --json " + scene(json));
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(Json::accept(run.out)) << run.out;
  EXPECT_CONTAINS(run.err, "weft: warning: ");
  EXPECT_CONTAINS(run.err, text);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << "said once: " << run.err;
  json.erase("wind");
  EXPECT_TRUE(Json::parse(run_weft("check --json " + scene(json)).out)["diagnostics"].empty());
}

TEST_F(Surroundings, WindThatMissesASingleRowIsADiagnostic) {
  Json json = still_scene();
  json["cloths"][0]["grid"]["rows"] = 1;
  json["wind"] = {{"velocity", {0, 0, 2}}};
  const Outcome outcome = run_weft("check " + scene(json));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_CONTAINS(outcome.out, "cloth \"sheet\" is one row or column (it has no triangles");
}

TEST_F(Surroundings, TheReportCountsSleepingCloths) {
  Json json = still_scene();
  EXPECT_EQ(report(json)["asleep"], 0);
  json["cloths"][0]["sleep"] = {{"speed", 0.01}, {"time", 0.05}};
  EXPECT_EQ(report(json)["asleep"], 1);
  json["cloths"].push_back(network_cloth());
  EXPECT_EQ(report(json)["asleep"], 1);
  json["cloths"][0]["velocity"] = {0, 0, 1};
  EXPECT_EQ(report(json)["asleep"], 0) << "it moves";
}

TEST_F(Surroundings, ThreadsDoNotChangeABitOfAFlagInTheWind) {
  const std::string sample = std::string(WEFT_SAMPLE_SCENES) + "/flag_in_wind.json";
  const Json one = Json::parse(run_weft("run --time 0.2 --threads 1 --json " + sample).out);
  const Json three = Json::parse(run_weft("run --time 0.2 --threads 3 --json " + sample).out);
  EXPECT_EQ(one["state_hash"], three["state_hash"]);
}

}  // namespace
}  // namespace weft::io::test
