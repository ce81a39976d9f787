// Usage, check and plan.
#include "cli_support.h"

namespace weft::io::test {
namespace {

TEST(Cli, HelpAndVersionSucceed) {
  EXPECT_EQ(run_weft("--help").code, 0);
  EXPECT_EQ(run_weft("run --help").code, 0);
  EXPECT_CONTAINS(run_weft("--version").out, "weft ");
}

TEST(Cli, BadUsageIsExitCode2) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("s.json", falling_scene().dump());
  expect_failure(run_weft(""), 2, "subcommand is required");
  expect_failure(run_weft("chekc x"), 2, "'chekc' is not a command (known are run, check, plan");
  expect_failure(run_weft("chekc x"), 2, "did you mean 'check'?");
  expect_failure(run_weft("run"), 2, "SCENE is required");
  expect_failure(run_weft("run a b"), 2, "b");
  expect_failure(run_weft("run --what " + scene), 2, "--what");
  expect_failure(run_weft("check --time 1 " + scene), 2, "--time");
  expect_failure(run_weft("run --time -1 " + scene), 2, "--time: '-1' is out of range");
  expect_failure(run_weft("run --time nan " + scene), 2, "--time: 'nan'");
  expect_failure(run_weft("run --time 1e999 " + scene), 2, "--time: '1e999'");
  expect_failure(run_weft("run --time 1e300 " + scene), 2, "--time: 1e+300");
  expect_failure(run_weft("run --every 0 --out x " + scene), 2, "--every: '0' is out of range");
  expect_failure(run_weft("run --every 1 " + scene), 2, "--out: is missing");
  expect_failure(run_weft("run --normals " + scene), 2, "--out: is missing");
  expect_failure(run_weft("run --size 64x64 " + scene), 2, "--out: is missing");
  for (const char* size :
       {"64", "64x", "x64", "64x15", "8193x64", "64x64x64", "-64x64", "64.5x64"}) {
    expect_failure(run_weft("run --out x --size '" + std::string(size) + "' " + scene), 2,
                   "--size: '" + std::string(size) + "' is not a size");
  }
  expect_failure(run_weft("check --normals " + scene), 2, "--normals");
  expect_failure(run_weft("run --format obj,stl --out x " + scene), 2, "--format: 'stl'");
  expect_failure(run_weft("run --threads 0 " + scene), 2, "--threads: '0'");
  expect_failure(run_weft("run --isa v9 " + scene), 2, "--isa: 'v9'");
  expect_failure(run_weft("run --backend vulkan " + scene), 2, "--backend: 'vulkan'");
  EXPECT_FALSE(std::filesystem::exists("x"));
}

TEST(Cli, LaterCommandsSaySo) {
  expect_failure(run_weft("accuracy s.json --tolerance 1e-3"), 2, "not available in this version");
}

TEST(Cli, UnknownBenchIsExitCode2) { expect_failure(run_weft("bench nothing"), 2, "bench: "); }

TEST(Cli, AbsentBackendIsExitCode4) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("s.json", falling_scene().dump());
  expect_failure(run_weft("run --backend hip " + scene), 4, "hip");
  expect_failure(run_weft("check --backend hip " + scene), 4, "hip");
}

TEST(Check, CountsAndBounds) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("s.json", scene_of(network_cloth()).dump());
  const Json json = Json::parse(run_weft("check --json " + scene).out);
  EXPECT_EQ(json["particles"], 3);
  EXPECT_EQ(json["springs"], 3);
  // S = 150, 150 and 100 N/m over 1/3 kg; the worst spring is 0-1.
  EXPECT_NEAR(json["dt_bound"].get<double>(), 2 / std::sqrt(3 * (150 + 150.0)), 1e-6);
  EXPECT_GT(json["bytes_total"], 0);
  EXPECT_TRUE(json["diagnostics"].empty());
  const Outcome human = run_weft("check " + scene);
  EXPECT_EQ(human.code, 0);
  EXPECT_CONTAINS(human.out, "particles   3\n");
}

TEST(Check, HasNoBoundWithoutSprings) {
  const TemporaryFolder folder;
  Json cloth = network_cloth();
  cloth["network"]["springs"] = Json::array();
  const std::string scene = folder.write("s.json", scene_of(cloth).dump());
  EXPECT_TRUE(Json::parse(run_weft("check --json " + scene).out)["dt_bound"].is_null());
}

TEST(Check, ReportsWhatIsOdd) {
  const TemporaryFolder folder;
  Json cloth = network_cloth();
  cloth["network"]["springs"].push_back({1, 0});
  Json scene = scene_of(cloth);
  scene["time"] = {{"substeps", 1}, {"frame", 1}};
  const Outcome outcome = run_weft("check --json " + folder.write("s.json", scene.dump()));
  EXPECT_EQ(outcome.code, 0);
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["diagnostics"].size(), 2u) << outcome.out;
  EXPECT_EQ(json["diagnostics"][0]["cloth"], 0);
  EXPECT_EQ(json["diagnostics"][1]["severity"], "warning");
  EXPECT_CONTAINS(json["diagnostics"][1]["text"].get<std::string>(), "1 is too few");
  EXPECT_CONTAINS(json["diagnostics"][1]["text"].get<std::string>(), "spring 0-1");
}

TEST(Plan, ListsPasses) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("s.json", falling_scene().dump());
  const Json json = Json::parse(run_weft("plan --json " + scene).out);
  ASSERT_FALSE(json["passes"].empty());
  for (const Json& pass : json["passes"]) {
    for (const char* key :
         {"stage", "per", "kernel", "count", "bytes_per_particle", "flops_per_particle"}) {
      EXPECT_TRUE(pass.contains(key)) << key;
    }
    const std::string per = pass["per"];
    EXPECT_TRUE(per == "substep" || per == "frame" || per == "call") << per;
  }
  EXPECT_GT(json["bytes_total"], 0);
  const std::string table = run_weft("plan " + scene).out;
  EXPECT_EQ(table.rfind("stage        per      kernel ", 0), 0u) << table;
  EXPECT_CONTAINS(table, "\nadvance      substep  grid_seed12_float64 ");
}

TEST(Samples, AreValidAndStableWithAutomaticSubsteps) {
  size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(WEFT_SAMPLE_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().string());
    if (sample_scene(entry.path()).is_null()) continue;
    ++count;
    const Outcome outcome =
        run_weft("run --backend omp --time 0.1 --json " + entry.path().string());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json report = Json::parse(outcome.out);
    EXPECT_LE(report["substeps_per_frame"], 64);
    EXPECT_TRUE(report["events"].empty());
    EXPECT_TRUE(report["energy"]["kinetic"].is_number());
  }
  EXPECT_GE(count, 4u);
}

}  // namespace
}  // namespace weft::io::test
