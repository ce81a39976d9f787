// Evaluation and accumulation from the command line.
#include "cli_support.h"

namespace weft::io::test {
namespace {

/// Two masses on a spring, of which one flies away.
Json pair_of_masses(double speed) {
  return Json::parse(R"({"weft": 1, "gravity": [0, 0, 0],
    "time": {"duration": 0.1, "frame": 0.001, "substeps": 1},
    "solver": {"evaluation": "scatter", "accumulate": "fixed64"},
    "cloths": [{"name": "pair", "mass": 2, "stiffness": {"stretch": 1},
                "network": {"positions": [[0, 0, 0], [1, 0, 0]], "springs": [[0, 1]]},
                "velocities": [[0, 0, 0], [)" +
                     std::to_string(speed) + R"(, 0, 0]]}]})");
}

class CliScatter : public ::testing::Test {
 protected:
  TemporaryFolder folder;
  std::string scene(const Json& json) const { return folder.write("s.json", json.dump()); }
  Json report_of(Json json, const char* evaluation, const char* accumulate) {
    json["solver"]["evaluation"] = evaluation;
    json["solver"]["accumulate"] = accumulate;
    const Outcome outcome = run_weft("run --json " + scene(json));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(CliScatter, NativeHasTheHashOfTheGatherAndTheReportNamesIt) {
  const Json json = pair_of_masses(1);
  const Json gather = report_of(json, "gather", "native");
  const Json scatter = report_of(json, "scatter", "native");
  EXPECT_EQ(gather["evaluation"], "gather");
  EXPECT_EQ(scatter["evaluation"], "scatter");
  EXPECT_EQ(scatter["state_hash"], gather["state_hash"]);
  for (const char* mode : {"fixed64", "float16", "float24", "float24_all", "fixed8"}) {
    EXPECT_EQ(report_of(json, "scatter", mode)["evaluation"], "scatter") << mode;
  }
}

TEST_F(CliScatter, EverySampleSceneHasTheSameHashBothWays) {
  size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(WEFT_SAMPLE_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    Json json = sample_scene(entry.path());
    if (json.is_null()) continue;
    const Json::json_pointer integrator("/solver/integrator");
    if (json.value(integrator, "verlet") != "verlet") continue;  // its springs are no forces
    ++scenes;
    // A single frame of the folding sheet, which has the most particles and contact.
    const std::string time = entry.path().stem() == "fold" ? "0.01" : "0.04";
    for (const char* precision : {"float32", "float64"}) {
      json["solver"]["precision"] = precision;
      std::vector<std::string> hashes;
      for (const char* evaluation : {"gather", "scatter"}) {
        json["solver"]["evaluation"] = evaluation;
        for (const char* threads : {"1", "2", "3"}) {
          const Outcome outcome = run_weft("run --json --time " + time + " --threads " +
                                           std::string(threads) + " " + scene(json));
          ASSERT_EQ(outcome.code, 0) << outcome.err;
          hashes.push_back(Json::parse(outcome.out)["state_hash"]);
        }
      }
      for (const std::string& hash : hashes) {
        EXPECT_EQ(hash, hashes[0]) << entry.path() << " " << precision;
      }
    }
  }
  EXPECT_GE(scenes, 5u);
}

TEST_F(CliScatter, ForceBeyondTheRangeStopsTheRunWithItsName) {
  const Outcome outcome = run_weft("run " + scene(pair_of_masses(1e7)));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_CONTAINS(outcome.err, "vertex 0 of cloth");
  EXPECT_CONTAINS(outcome.err, "fixed64 counts up to 4096 N");
}

TEST_F(CliScatter, AtomicIsRefusedWithoutAWord) {
  Json json = pair_of_masses(1);
  json["solver"]["accumulate"] = "atomic";
  const Outcome outcome = run_weft("run " + scene(json));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_CONTAINS(outcome.err, "$.solver.accumulate");
  EXPECT_CONTAINS(outcome.err, "deterministic");
  json["solver"]["deterministic"] = false;
  EXPECT_EQ(run_weft("run " + scene(json)).code, 0);
}

TEST_F(CliScatter, PlanSaysWhatIsChosenAndWhy) {
  Json json = pair_of_masses(1);
  json["solver"] = {{"evaluation", "auto"}};
  const Json plan = Json::parse(run_weft("plan --json " + scene(json)).out);
  ASSERT_EQ(plan["evaluations"].size(), 1u);
  const Json& of = plan["evaluations"][0];
  EXPECT_EQ(of["cloth"], 0);
  EXPECT_EQ(of["chosen"], of["scatter_ns"] < of["gather_ns"] ? "scatter" : "gather");
  EXPECT_GT(of["gather_ns"], 0);
  EXPECT_GT(of["scatter_ns"], 0);
  const std::string line =
      "cloth 0: " + of["chosen"].get<std::string>() + " (model, ns per substep";
  EXPECT_CONTAINS(run_weft("plan " + scene(json)).out, line);
  json["solver"] = {{"evaluation", "scatter"}};
  EXPECT_CONTAINS(run_weft("plan " + scene(json)).out, "edge_forces_float32 native");
}

}  // namespace
}  // namespace weft::io::test
