// The root of a scene, "time" and "solver".
#include "scene_support.h"

namespace weft::io::test {
namespace {

TEST(Scene, HasTheDefaultsOfThePage) {
  const Scene scene = read_json(scene_of(grid_cloth()));
  EXPECT_EQ(scene.gravity.y, -9.81);
  EXPECT_EQ(scene.time.duration, 1);
  EXPECT_EQ(scene.time.frame, 0.016666666666666666);
  EXPECT_EQ(scene.time.substeps, 0u);
  EXPECT_EQ(scene.solver.precision, Precision::float32);
  EXPECT_EQ(scene.solver.safety, 0.9);
  EXPECT_TRUE(scene.solver.deterministic);
  EXPECT_FALSE(scene.solver.unsafe);
  const ClothScene& cloth = scene.cloths[0];
  EXPECT_EQ(cloth.scale, 1);
  EXPECT_EQ(cloth.rest_length, initial_rest_length);
  EXPECT_EQ(cloth.stiffness.bend, 100);
  EXPECT_EQ(cloth.drag_model, DragModel::central);
}

TEST(Scene, ReadsEverySetting) {
  Json json = scene_of(grid_cloth());
  json["gravity"] = {0, 0, 1.5};
  json["time"] = {{"duration", 0}, {"frame", 0.5}, {"substeps", 7}};
  json["solver"] = Json::parse(R"({ "integrator": "verlet", "form": "position", "start": "lagged",
    "precision": "float64", "evaluation": "gather", "accumulate": "native",
    "deterministic": false, "safety": 1, "energy_guard": false, "unsafe": true })");
  json["wind"] = nullptr;
  json["self_collision"] = nullptr;
  json["colliders"] = Json::array();
  const Scene scene = read_json(json);
  EXPECT_EQ(scene.gravity.z, 1.5);
  EXPECT_EQ(scene.time.duration, 0);
  EXPECT_EQ(scene.time.substeps, 7u);
  EXPECT_EQ(scene.solver.form, Form::position);
  EXPECT_EQ(scene.solver.start, Start::lagged);
  EXPECT_EQ(scene.solver.precision, Precision::float64);
  EXPECT_EQ(scene.solver.energy_guard, EnergyGuard::off);
  EXPECT_TRUE(scene.solver.unsafe);
}

TEST(Scene, RefusesBadRoots) {
  expect_refused(scene_of(grid_cloth()),
                 {{"/weft", "", "$.weft", "is missing"},
                  {"/weft", "2", "$.weft", "2 is out of range"},
                  {"/weft", "\"1\"", "$.weft", "\"1\" has the wrong type"},
                  {"/cloths", "", "$.cloths", "is missing"},
                  {"/cloths", "[]", "$.cloths", "is empty"},
                  {"/cloths", "{}", "$.cloths", "an object has the wrong type"},
                  {"/cloths/0", "3", "$.cloths[0]", "3 has the wrong type"},
                  {"/gravty", "[0,0,0]", "$.gravty", "did you mean \"gravity\"?"},
                  {"/gravity", "-9.81", "$.gravity", "-9.81 has the wrong type"},
                  {"/gravity", "[0,1]", "$.gravity", "an array of 2"},
                  {"/gravity", "[0,1,\"2\"]", "$.gravity[2]", "\"2\" has the wrong type"},
                  {"/colliders", "{}", "$.colliders", "wrong type"},
                  {"/new\n\"key", "1", "$.new?\"key", "unknown key"}});
  EXPECT_CONTAINS(input_error([] { read_scene_text("[]", "s.json"); }), "$: an array of 0");
}

TEST(Scene, RefusesBadTimes) {
  Json base = scene_of(grid_cloth());
  base["time"] = Json::object();
  expect_refused(base,
                 {{"/time", "1", "$.time", "1 has the wrong type"},
                  {"/time/duration", "-1", "$.time.duration", "-1 is out of range"},
                  {"/time/duration", "1e300", "$.time.duration", "1e+300 is out of range"},
                  {"/time/frame", "0", "$.time.frame", "0 is out of range"},
                  {"/time/frame", "-0.1", "$.time.frame", "-0.1 is out of range"},
                  {"/time/substeps", "0", "$.time.substeps", "0 is out of range"},
                  {"/time/substeps", "-3", "$.time.substeps", "-3 is out of range"},
                  {"/time/substeps", "2.5", "$.time.substeps", "2.5 has the wrong type"},
                  {"/time/substeps", "\"many\"", "$.time.substeps", "give \"auto\""},
                  {"/time/substeps", "18446744073709551615", "$.time.substeps", "out of range"},
                  {"/time/step", "1", "$.time.step", "unknown key"}});
}

TEST(Scene, RefusesBadSolvers) {
  Json base = scene_of(grid_cloth());
  base["solver"] = Json::object();
  expect_refused(base,
                 {{"/solver/integrator", "\"euler\"", "$.solver.integrator", "\"euler\""},
                  {"/solver/form", "\"sum\"", "$.solver.form", "give \"summed\" or \"position\""},
                  {"/solver/start", "1", "$.solver.start", "give \"taylor\" or \"lagged\""},
                  {"/solver/precision", "\"double\"", "$.solver.precision", "\"double\""},
                  {"/solver/evaluation", "\"any\"", "$.solver.evaluation", "\"any\""},
                  {"/solver/accumulate", "\"int\"", "$.solver.accumulate", "\"int\""},
                  {"/solver/deterministic", "1", "$.solver.deterministic", "true or false"},
                  {"/solver/safety", "0", "$.solver.safety", "0 is out of range"},
                  {"/solver/safety", "1.01", "$.solver.safety", "1.01 is out of range"},
                  {"/solver/energy_guard", "\"on\"", "$.solver.energy_guard", "\"on\""},
                  {"/solver/energy_guard", "1", "$.solver.energy_guard", "1 has the wrong type"},
                  {"/solver/unsafe", "\"yes\"", "$.solver.unsafe", "\"yes\""},
                  {"/solver/Form", "1", "$.solver.Form", "did you mean \"form\"?"}});
}

TEST(Scene, RefusesAccumulationThatDoesNotFit) {
  Json base = scene_of(grid_cloth());
  base["solver"] = {{"evaluation", "gather"}};
  expect_refused(base, {{"/solver/accumulate", "\"fixed64\"", "$.solver.accumulate", "scatter"},
                        {"/solver/accumulate", "\"atomic\"", "$.solver.accumulate",
                         "\"atomic\" is refused while deterministic is true"}});
}

TEST(Scene, CountsFrames) {
  EXPECT_EQ(frame_count({1, 1.0 / 60, 0}, "p"), 60u);
  EXPECT_EQ(frame_count({0, 1.0 / 60, 0}, "p"), 0u);
  EXPECT_EQ(frame_count({1.001, 0.5, 0}, "p"), 3u);
  EXPECT_EQ(frame_count({1e-9, 0.5, 0}, "p"), 0u);
  EXPECT_EQ(frame_count({0.3, 0.1, 0}, "p"), 3u);
  EXPECT_CONTAINS(input_error([] { frame_count({1e300, 1e-300, 0}, "--time"); }), "--time: 1e+300");
}

}  // namespace
}  // namespace weft::io::test
