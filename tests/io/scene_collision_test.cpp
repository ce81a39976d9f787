// "collision" of a scene's cloth.
#include "scene_support.h"

namespace weft::io::test {
namespace {

ClothScene colliding(const char* value) {
  Json json = grid_cloth();
  json["collision"] = Json::parse(value);
  return read_cloth_json(json);
}

TEST(SceneCollision, ReadsItsKeysAndTheirDefaults) {
  for (const ClothScene& plain :
       {read_cloth_json(grid_cloth()), colliding("{}"), colliding(R"({"distance": null})")}) {
    EXPECT_EQ(plain.collision_distance, 0) << "the scene's";
    EXPECT_EQ(plain.collides_itself, 1);
    EXPECT_EQ(plain.collides_others, 1);
    EXPECT_EQ(plain.collision_layers, 4294967295u);
  }
  const ClothScene cloth =
      colliding(R"({"distance": 0.25, "itself": false, "others": false, "layers": 5})");
  EXPECT_EQ(cloth.collision_distance, 0.25);
  EXPECT_EQ(cloth.collides_itself, 0);
  EXPECT_EQ(cloth.collides_others, 0);
  EXPECT_EQ(cloth.collision_layers, 5u);
  EXPECT_EQ(colliding(R"({"itself": false})").collides_others, 1);
  EXPECT_EQ(colliding(R"({"layers": 0})").collision_layers, 0u);
}

TEST(SceneCollision, RefusesBadValuesWithPathAndValue) {
  Json base = grid_cloth();
  base["collision"] = Json::object();
  expect_refused(
      scene_of(base),
      {{"/cloths/0/collision", "3", "$.cloths[0].collision", "3 has the wrong type"},
       {"/cloths/0/collision", "null", "$.cloths[0].collision", "null has the wrong type"},
       {"/cloths/0/collision/distance", "0", "$.cloths[0].collision.distance", "0 is out"},
       {"/cloths/0/collision/distance", "-1", "$.cloths[0].collision.distance", "-1 is out"},
       {"/cloths/0/collision/distance", "\"1\"", "$.cloths[0].collision.distance", "\"1\" has"},
       {"/cloths/0/collision/itself", "1", "$.cloths[0].collision.itself", "1 has the wrong type"},
       {"/cloths/0/collision/others", "null", "$.cloths[0].collision.others", "null has the"},
       {"/cloths/0/collision/layers", "-1", "$.cloths[0].collision.layers", "-1 is out of range"},
       {"/cloths/0/collision/layers", "4294967296", "$.cloths[0].collision.layers",
        "4294967296 is out of range"},
       {"/cloths/0/collision/layers", "1.5", "$.cloths[0].collision.layers", "1.5 has the wrong"},
       {"/cloths/0/collision/layer", "1", "$.cloths[0].collision.layer", "unknown key"}});
}

}  // namespace
}  // namespace weft::io::test
