// Everything of a cloth but its shape.
#include "scene_support.h"

namespace weft::io::test {
namespace {

TEST(SceneCloth, ReadsEveryKey) {
  Json json = grid_cloth();
  json.update(
      Json::parse(R"({ "transform": { "scale": 2, "rotate": { "axis": [0,1,0], "degrees": 90 },
      "translate": [1,2,3] }, "stiffness": { "stretch": 1, "shear": 2, "bend": 3 },
    "rest_length": 0.25, "damping": { "drag": 0.1, "spring": 0.2, "drag_model": "lagged" },
    "velocity": [1,0,0], "forces": [{ "vertices": [0, 11], "force": [0,0,5] }] })"));
  const ClothScene cloth = read_cloth_json(json);
  EXPECT_EQ(cloth.scale, 2);
  EXPECT_EQ(cloth.pose.degrees, 90);
  EXPECT_EQ(cloth.pose.translate.z, 3);
  EXPECT_EQ(cloth.stiffness.shear, 2);
  EXPECT_EQ(cloth.rest_length, 0.25);
  EXPECT_EQ(cloth.spring_damping, 0.2);
  EXPECT_EQ(cloth.drag_model, DragModel::lagged);
  EXPECT_EQ(cloth.velocity.x, 1);
  ASSERT_EQ(cloth.forces.size(), 2u);
  EXPECT_EQ(cloth.forces[1].vertex, 11u);
}

TEST(SceneCloth, RefusesBadValues) {
  Json base = grid_cloth();
  base.update(Json::parse(R"({"transform": {"rotate": {"degrees": 5}}, "damping": {},
    "forces": [{"vertices": [0], "force": [0,0,0]}]})"));
  expect_refused(
      scene_of(base),
      {{"/cloths/0/name", "", "$.cloths[0].name", "is missing"},
       {"/cloths/0/name", "\"\"", "$.cloths[0].name", "\"\" is not a name"},
       {"/cloths/0/colour", "1", "$.cloths[0].colour", "unknown key"},
       {"/cloths/0/transform/scale", "0", "$.cloths[0].transform.scale", "0 is out of range"},
       {"/cloths/0/transform/rotate/axis", "[0,0,0]", "$.cloths[0].transform.rotate.axis",
        "no direction"},
       {"/cloths/0/transform/rotate/angle", "3", "$.cloths[0].transform.rotate.angle", "unknown"},
       {"/cloths/0/transform/translate", "3", "$.cloths[0].transform.translate", "3 has the"},
       {"/cloths/0/damping/drag", "-1", "$.cloths[0].damping.drag", "-1 is out of range"},
       {"/cloths/0/damping/spring", "-1", "$.cloths[0].damping.spring", "-1 is out of range"},
       {"/cloths/0/damping/drag_model", "\"x\"", "$.cloths[0].damping.drag_model", "\"x\""},
       {"/cloths/0/rest_length", "-1", "$.cloths[0].rest_length", "-1 is out of range"},
       {"/cloths/0/rest_length", "\"x\"", "$.cloths[0].rest_length", "\"initial\""},
       {"/cloths/0/velocity", "1", "$.cloths[0].velocity", "1 has the wrong type"},
       {"/cloths/0/velocities", "[[0,0,0]]", "$.cloths[0].velocities", "12 vertices"},
       {"/cloths/0/forces", "{}", "$.cloths[0].forces", "wrong type"},
       {"/cloths/0/forces/0/force", "", "$.cloths[0].forces[0].force", "is missing"},
       {"/cloths/0/forces/0/vertices", "[12]", "$.cloths[0].forces[0].vertices[0]",
        "12 is out of range (there are 12 vertices)"}});
}

TEST(SceneCloth, SleepsWhenAsked) {
  Json json = grid_cloth();
  EXPECT_EQ(read_cloth_json(json).sleep_speed, 0) << "never";
  json["sleep"] = nullptr;
  EXPECT_EQ(read_cloth_json(json).sleep_speed, 0);
  json["sleep"] = {{"speed", 0.01}};
  EXPECT_EQ(read_cloth_json(json).sleep_speed, 0.01);
  EXPECT_EQ(read_cloth_json(json).sleep_time, 0.5);
  json["sleep"]["time"] = 0;
  EXPECT_EQ(read_cloth_json(json).sleep_time, 0);
  expect_refused(
      scene_of(json),
      {{"/cloths/0/sleep", "true", "$.cloths[0].sleep", "true has the wrong type"},
       {"/cloths/0/sleep", "0.01", "$.cloths[0].sleep", "0.01 has the wrong type"},
       {"/cloths/0/sleep/speed", "", "$.cloths[0].sleep.speed", "is missing"},
       {"/cloths/0/sleep/speed", "0", "$.cloths[0].sleep.speed", "0 is out of range"},
       {"/cloths/0/sleep/speed", "-1", "$.cloths[0].sleep.speed", "-1 is out of range"},
       {"/cloths/0/sleep/time", "-0.1", "$.cloths[0].sleep.time", "-0.1 is out of range"},
       {"/cloths/0/sleep/time", "null", "$.cloths[0].sleep.time", "null has the wrong type"},
       {"/cloths/0/sleep/delay", "1", "$.cloths[0].sleep.delay", "unknown key"}});
}

TEST(SceneCloth, ReadsMasses) {
  Json json = network_cloth();
  json.erase("mass");
  json["masses"] = {1, 2, 3.5};
  const ClothScene cloth = read_cloth_json(json);
  EXPECT_EQ(cloth.mass_kind, Mass::Kind::per_vertex);
  EXPECT_EQ(cloth.masses[2], 3.5);
  expect_refused(scene_of(json),
                 {{"/cloths/0/masses", "[1,2]", "$.cloths[0].masses", "3 vertices"},
                  {"/cloths/0/masses/1", "0", "$.cloths[0].masses[1]", "0 is out of range"},
                  {"/cloths/0/mass", "1", "$.cloths[0]", "has mass and masses"},
                  {"/cloths/0/masses", "", "$.cloths[0]", "none of mass, density, masses"}});
}

TEST(SceneCloth, DensityNeedsTriangles) {
  Json grid = grid_cloth();
  grid.erase("mass");
  grid["density"] = 0.5;
  EXPECT_EQ(read_cloth_json(grid).mass_kind, Mass::Kind::density);
  expect_refused(scene_of(grid),
                 {{"/cloths/0/grid/rows", "1", "$.cloths[0].density", "0.5 is a mass"},
                  {"/cloths/0/density", "0", "$.cloths[0].density", "0 is out"}});
  Json net = network_cloth();
  net.erase("mass");
  net["density"] = 1;
  EXPECT_CONTAINS(input_error([&] { read_cloth_json(net); }), "$.cloths[0].density: 1 is a mass");
}

TEST(SceneCloth, StiffnessIsNeededWhereSpringsLackIt) {
  Json json = network_cloth();
  json.erase("stiffness");
  EXPECT_CONTAINS(input_error([&] { read_cloth_json(json); }), "$.cloths[0].stiffness: is missing");
  json["network"]["springs"] = {{0, 1, 10}};
  read_cloth_json(json);
  json["network"]["springs"] = Json::array();
  read_cloth_json(json);
  Json grid = grid_cloth();
  expect_refused(scene_of(grid),
                 {{"/cloths/0/stiffness", "", "$.cloths[0].stiffness", "is missing"},
                  {"/cloths/0/stiffness", "-1", "$.cloths[0].stiffness", "-1 is out of range"},
                  {"/cloths/0/stiffness", "{\"stretch\": 1, \"shear\": 1}",
                   "$.cloths[0].stiffness.bend", "is missing"},
                  {"/cloths/0/stiffness", "{\"stretch\": 1, \"strech\": 1}",
                   "$.cloths[0].stiffness.strech", "did you mean \"stretch\"?"}});
  grid["grid"]["rows"] = grid["grid"]["columns"] = 1;
  grid.erase("stiffness");
  read_cloth_json(grid);
}

TEST(SceneCloth, VelocitiesReplaceVelocity) {
  Json json = network_cloth();
  json["velocities"] = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}};
  EXPECT_EQ(read_cloth_json(json).velocities[2].z, 2);
  json["velocity"] = {0, 0, 0};
  EXPECT_CONTAINS(input_error([&] { read_cloth_json(json); }),
                  "$.cloths[0].velocities: stands beside \"velocity\"");
}

std::vector<uint32_t> pinned(const Json& pins) {
  Json json = grid_cloth();
  json["pins"] = pins;
  std::vector<uint32_t> vertices;
  for (const Pin& pin : read_cloth_json(json).pins) vertices.push_back(pin.vertex);
  return vertices;
}

TEST(ScenePins, NameVerticesRowsColumnsAndCorners) {
  using List = std::vector<uint32_t>;
  EXPECT_EQ(pinned({5, 2}), (List{2, 5}));
  EXPECT_EQ(pinned(Json::parse(R"([{"rows": [1]}])")), (List{4, 5, 6, 7}));
  EXPECT_EQ(pinned(Json::parse(R"([{"columns": [3]}])")), (List{3, 7, 11}));
  EXPECT_EQ(pinned(Json::parse(R"([{"corners": true}])")), (List{0, 3, 8, 11}));
  EXPECT_EQ(pinned(Json::parse(R"([{"corners": true, "rows": [0]}, 1])")),
            (List{0, 1, 2, 3, 8, 11}));
  EXPECT_EQ(pinned(Json::parse(R"([{}])")), List{});
}

TEST(ScenePins, FollowAMotion) {
  Json json = grid_cloth();
  json["pins"] = Json::parse(R"([0, {"vertices": [4], "motion":
      {"velocity": [1,0,0], "amplitude": [0,2,0], "omega": 3}}])");
  const ClothScene cloth = read_cloth_json(json);
  EXPECT_EQ(cloth.pins[0].motion, Pin::fixed);
  EXPECT_EQ(cloth.motions.at(cloth.pins[1].motion).omega, 3);
}

TEST(ScenePins, RefuseBadValues) {
  Json base = grid_cloth();
  base["pins"] = Json::parse(R"([0, {"vertices": [1], "motion": {"omega": 1}}])");
  expect_refused(
      scene_of(base),
      {{"/cloths/0/pins", "3", "$.cloths[0].pins", "3 has the wrong type"},
       {"/cloths/0/pins/0", "12", "$.cloths[0].pins[0]", "12 is out of range"},
       {"/cloths/0/pins/0", "-1", "$.cloths[0].pins[0]", "-1 is out of range"},
       {"/cloths/0/pins/0", "1.5", "$.cloths[0].pins[0]", "1.5 has the wrong type"},
       {"/cloths/0/pins/1/vertices", "[12]", "$.cloths[0].pins[1].vertices[0]", "12 is out"},
       {"/cloths/0/pins/1/rows", "[3]", "$.cloths[0].pins[1].rows[0]", "there are 3 rows"},
       {"/cloths/0/pins/1/columns", "[4]", "$.cloths[0].pins[1].columns[0]", "there are 4"},
       {"/cloths/0/pins/1/corners", "1", "$.cloths[0].pins[1].corners", "1 has the wrong type"},
       {"/cloths/0/pins/1/motion/speed", "1", "$.cloths[0].pins[1].motion.speed", "unknown"},
       {"/cloths/0/pins/0", "{\"vertices\": [1], \"motion\": {\"velocity\": [1,0,0]}}",
        "$.cloths[0].pins", "vertex 1 is pinned twice"}});
  Json net = network_cloth();
  net["pins"] = Json::parse(R"([{"rows": [0]}])");
  EXPECT_CONTAINS(input_error([&] { read_cloth_json(net); }),
                  "$.cloths[0].pins[0].rows: needs a grid");
  net["pins"] = Json::parse(R"([{"corners": true}])");
  EXPECT_CONTAINS(input_error([&] { read_cloth_json(net); }), "corners: needs a grid");
}

}  // namespace
}  // namespace weft::io::test
