// "colliders", "wind", "self_collision", and what is not available yet.
#include "scene_support.h"

#include "io/build.h"

namespace weft::io::test {
namespace {

Json with(const char* key, const char* value) {
  Json json = scene_of(grid_cloth());
  json[key] = Json::parse(value);
  return json;
}

TEST(SceneSurroundings, ReadsSpheresAndPlanes) {
  const Scene scene = read_json(with("colliders", R"([
    { "sphere": { "center": [1,2,3], "radius": 0.5 }, "friction": 0, "velocity": [0,1,0] },
    { "plane": { "normal": [0,2,0], "offset": -1 } }])"));
  const auto& sphere = std::get<SphereDesc>(scene.colliders[0]);
  EXPECT_EQ(sphere.center.z, 3);
  EXPECT_EQ(sphere.radius, 0.5);
  EXPECT_EQ(sphere.velocity.y, 1);
  EXPECT_EQ(std::get<PlaneDesc>(scene.colliders[1]).offset, -1);
}

TEST(SceneSurroundings, EveryShapeBringsItsFrictionAndVelocity) {
  const Scene scene = read_json(with("colliders", R"([
    { "cylinder": { "a": [0,0,0], "b": [0,2,0], "radius": 0.5 }, "friction": 0.25 },
    { "capsule": { "a": [1,0,0], "b": [1,0,0], "radius": 0.1 }, "velocity": [0,0,3] },
    { "box": { "center": [0,1,0], "half": [1,2,3],
               "rotate": { "axis": [0,0,1], "degrees": 30 } }, "friction": 1 } ])"));
  const auto& cylinder = std::get<CylinderDesc>(scene.colliders[0]);
  EXPECT_EQ(cylinder.b.y, 2);
  EXPECT_EQ(cylinder.friction, 0.25);
  EXPECT_EQ(std::get<CapsuleDesc>(scene.colliders[1]).velocity.z, 3);
  const auto& box = std::get<BoxDesc>(scene.colliders[2]);
  EXPECT_EQ(box.half.z, 3);
  EXPECT_EQ(box.degrees, 30);
  EXPECT_EQ(box.friction, 1);
}

TEST(SceneSurroundings, RefusesBadColliders) {
  const Json base = with("colliders", R"([{"sphere": {"center": [0,0,0], "radius": 1}}, {"plane":
    {"normal": [0,1,0], "offset": 0}}])");
  expect_refused(
      base,
      {{"/colliders/0/sphere/radius", "0", "$.colliders[0].sphere.radius", "0 is out of range"},
       {"/colliders/0/sphere/radius", "-1", "$.colliders[0].sphere.radius", "-1 is out of range"},
       {"/colliders/0/sphere/radius", "", "$.colliders[0].sphere.radius", "is missing"},
       {"/colliders/0/sphere/center", "", "$.colliders[0].sphere.center", "is missing"},
       {"/colliders/0/sphere", "", "$.colliders[0]",
        "none of sphere, plane, cylinder, capsule, box, mesh"},
       {"/colliders/0/plane", "{}", "$.colliders[0]", "has sphere and plane"},
       {"/colliders/0/cone", "{}", "$.colliders[0].cone", "unknown key"},
       {"/colliders/0/friction", "-1", "$.colliders[0].friction", "-1 is out of range"},
       {"/colliders/0/velocity", "1", "$.colliders[0].velocity", "1 has the wrong type"},
       {"/colliders/0/layers", "-1", "$.colliders[0].layers", "-1 is out of range"},
       {"/colliders/0/layers", "4294967296", "$.colliders[0].layers", "4294967296 is out of range"},
       {"/colliders/0/layers", "[1]", "$.colliders[0].layers", "has the wrong type"},
       {"/colliders/1/plane/normal", "[0,0,0]", "$.colliders[1].plane.normal", "no direction"},
       {"/colliders/1/plane/offset", "", "$.colliders[1].plane.offset", "is missing"}});
}

TEST(SceneSurroundings, ReadsWind) {
  EXPECT_FALSE(read_json(scene_of(grid_cloth())).wind);
  EXPECT_FALSE(read_json(with("wind", "null")).wind);
  const auto plain = read_json(with("wind", R"({"velocity": [1,2,3]})")).wind;
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->velocity.z, 3);
  EXPECT_EQ(plain->air_density, 1.225);
  EXPECT_EQ(plain->normal, 1);
  EXPECT_EQ(plain->tangential, 0.02);
  const auto full = read_json(with("wind", R"({"velocity": [0,0,0], "air_density": 0,
    "normal": 0.5, "tangential": 0.25})"))
                        .wind;
  ASSERT_TRUE(full);
  EXPECT_EQ(full->air_density, 0);
  EXPECT_EQ(full->normal, 0.5);
  EXPECT_EQ(full->tangential, 0.25);
}

TEST(SceneSurroundings, RefusesBadWind) {
  expect_refused(with("wind", R"({"velocity": [1,0,0]})"),
                 {{"/wind", "3", "$.wind", "3 has the wrong type"},
                  {"/wind", "false", "$.wind", "false has the wrong type"},
                  {"/wind/velocity", "", "$.wind.velocity", "is missing"},
                  {"/wind/velocity", "[1,0]", "$.wind.velocity", "an array of 2"},
                  {"/wind/air_density", "-1", "$.wind.air_density", "-1 is out of range"},
                  {"/wind/normal", "-1", "$.wind.normal", "-1 is out of range"},
                  {"/wind/tangential", "-0.5", "$.wind.tangential", "-0.5 is out of range"},
                  {"/wind/tangential", "\"x\"", "$.wind.tangential", "\"x\" has the wrong"},
                  {"/wind/speed", "1", "$.wind.speed", "unknown key"}});
}

TEST(SceneSurroundings, EveryShapeBringsItsLayers) {
  const TemporaryFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Json json = with("colliders", R"([
    { "sphere": { "center": [0,0,0], "radius": 1 }, "layers": 1 },
    { "plane": { "normal": [0,1,0], "offset": 0 }, "layers": 0 },
    { "cylinder": { "a": [0,0,0], "b": [0,2,0], "radius": 0.5 }, "layers": 6 },
    { "capsule": { "a": [0,0,0], "b": [0,2,0], "radius": 0.5 }, "layers": 4294967295 },
    { "box": { "center": [0,1,0], "half": [1,2,3] }, "layers": 2147483648 },
    { "mesh": { "file": "a.obj" }, "layers": 9 },
    { "sphere": { "center": [0,0,0], "radius": 1 } } ])");
  const Scene scene = read_scene(folder.write("s.json", json.dump()));
  const uint32_t expected[] = {1, 0, 6, 4294967295u, 2147483648u, 9, 4294967295u};
  for (size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_EQ(std::visit([](const auto& c) { return c.layers; }, scene.colliders[i]), expected[i]);
  }
}

TEST(SceneSurroundings, ReadsSelfCollision) {
  EXPECT_FALSE(read_json(scene_of(grid_cloth())).self_collision);
  EXPECT_FALSE(read_json(with("self_collision", "null")).self_collision);
  const SelfCollisionDesc plain =
      self_collision_desc(*read_json(with("self_collision", "{}")).self_collision);
  EXPECT_EQ(plain.search, PairSearch::staggered);
  EXPECT_EQ(plain.distance, 0.01);
  EXPECT_EQ(plain.friction, 0);
  EXPECT_EQ(plain.cell, 0.02);
  EXPECT_EQ(plain.grids, 8u);
  EXPECT_EQ(plain.shifts, GridShifts::corner);
  EXPECT_EQ(plain.window, 0u);
  EXPECT_LT(plain.skin, 0);
  const SelfCollisionDesc full = self_collision_desc(
      *read_json(with("self_collision", R"({"method": "complete", "distance": 0.5, "friction": 0.25,
        "cell": 0.125, "grids": 7, "shifts": "diagonal", "window": 3, "skin": 0})"))
           .self_collision);
  EXPECT_EQ(full.search, PairSearch::complete);
  EXPECT_EQ(full.distance, 0.5);
  EXPECT_EQ(full.friction, 0.25);
  EXPECT_EQ(full.cell, 0.125);
  EXPECT_EQ(full.grids, 7u);
  EXPECT_EQ(full.shifts, GridShifts::diagonal);
  EXPECT_EQ(full.window, 3u);
  EXPECT_EQ(full.skin, 0);
  const auto nulls = read_json(with("self_collision", R"({"window": null, "skin": null})"));
  EXPECT_EQ(self_collision_desc(*nulls.self_collision).window, 0u);
}

struct Refusal {
  const char *key, *value, *message;
};

void expect_messages(const std::vector<Refusal>& cases) {
  for (const Refusal& refusal : cases) {
    SCOPED_TRACE(refusal.value);
    EXPECT_CONTAINS(input_error([&] { read_json(with(refusal.key, refusal.value)); }),
                    refusal.message);
  }
}

TEST(SceneSurroundings, WhatIsNotAvailableIsNamed) {
  expect_messages(
      {{"solver", R"({"integrator": "rk4"})",
        "$.solver.integrator: \"rk4\" is not available in this"},
       {"solver", R"({"integrator": "implicit_euler"})", "not available in this version"},
       {"solver", R"({"integrator": "implicit_midpoint"})", "not available in this version"},
       {"solver", R"({"integrator": "xpbd", "form": "position"})", "$.solver.form: \"position\""},
       {"solver", R"({"integrator": "xpbd", "evaluation": "scatter"})", "$.solver.evaluation"},
       {"solver", R"({"integrator": "xpbd", "iterations": 2})", "$.solver.iterations: 2 is out"},
       {"solver", R"({"iterations": 0})", "$.solver.iterations: 0 is out"},
       {"solver", R"({"integrator": "xpbd", "ladder": [4, 8]})", "$.solver.ladder[1]: 8 is out"},
       {"solver", R"({"ladder": [1]})", "$.solver.ladder[0]: 1 is out"},
       {"solver", R"({"ladder": "long"})", "$.solver.ladder: \"long\""},
       {"solver", R"({"ladder": [9, 8, 7, 6, 5, 4, 3]})", "$.solver.ladder[6]: 3 is out"},
       {"solver", R"({"energy_guard": true})", "$.solver.energy_guard: true is not available"}});
}

TEST(SceneSurroundings, GarbageIsNamed) {
  expect_messages(
      {{"self_collision", "[]", "$.self_collision: an array of 0"},
       {"self_collision", "true", "$.self_collision: true has the wrong type"},
       {"self_collision", R"({"distence": 1})", "$.self_collision.distence: unknown key"},
       {"self_collision", R"({"method": "all"})", "$.self_collision.method: \"all\""},
       {"self_collision", R"({"distance": 0})", "$.self_collision.distance: 0 is out"},
       {"self_collision", R"({"cell": -1})", "$.self_collision.cell: -1 is out"},
       {"self_collision", R"({"grids": 3})", "$.self_collision.grids: 3 is out"},
       {"self_collision", R"({"grids": 0, "shifts": "diagonal"})", "$.self_collision.grids: 0"},
       {"self_collision", R"({"grids": 65, "shifts": "diagonal"})", "$.self_collision.grids: 65"},
       {"self_collision", R"({"grids": 2.5})", "$.self_collision.grids: 2.5 has the wrong type"},
       {"self_collision", R"({"distance": -0.1})", "$.self_collision.distance: -0.1 is out"},
       {"self_collision", R"({"distance": null})", "$.self_collision.distance: null has the wrong"},
       {"self_collision", R"({"cell": 0})", "$.self_collision.cell: 0 is out"},
       {"self_collision", R"({"friction": -1})", "$.self_collision.friction: -1 is out"},
       {"self_collision", R"({"skin": -0.5})", "$.self_collision.skin: -0.5 is out"},
       {"self_collision", R"({"window": -3})", "$.self_collision.window: -3 is out"},
       {"self_collision", R"({"shifts": "x"})", "$.self_collision.shifts: \"x\""},
       {"self_collision", R"({"window": 0})", "$.self_collision.window: 0 is out"},
       {"colliders", R"([{"cylinder": {"a": [0,0,0], "b": [0,0,0], "radius": 1}}])",
        "$.colliders[0].cylinder.b: is equal to \"a\""},
       {"colliders", R"([{"cylinder": {"a": [0,0,0], "b": [0,1,0], "radius": 0}}])",
        "$.colliders[0].cylinder.radius: 0 is out"},
       {"colliders", R"([{"capsule": {"a": [0,0,0], "radius": 1}}])",
        "$.colliders[0].capsule.b: is"},
       {"colliders", R"([{"box": {"center": [0,0,0], "half": [1,0,1]}}])",
        "$.colliders[0].box.half[1]: 0 is out"}});
}

}  // namespace
}  // namespace weft::io::test
