// "tethers" of a scene's cloth.
#include "scene_support.h"

namespace weft::io::test {
namespace {

ClothScene tethered(const char* value) {
  Json json = grid_cloth();
  json["pins"] = Json::array({0});
  json["tethers"] = Json::parse(value);
  return read_cloth_json(json);
}

TEST(SceneTethers, ReadsItsKeysAndTheirDefaults) {
  EXPECT_EQ(read_cloth_json(grid_cloth()).tether_scale, 0);
  EXPECT_EQ(tethered("null").tether_scale, 0);
  EXPECT_EQ(tethered("{}").tether_scale, 1);
  EXPECT_EQ(tethered("{}").tether_compliance, 0);
  const ClothScene cloth = tethered(R"({"scale": 1.25, "compliance": 0.001})");
  EXPECT_EQ(cloth.tether_scale, 1.25);
  EXPECT_EQ(cloth.tether_compliance, 0.001);
}

TEST(SceneTethers, RefusesBadValuesWithPathAndValue) {
  Json base = grid_cloth();
  base["tethers"] = Json::object();
  expect_refused(
      scene_of(base),
      {{"/cloths/0/tethers", "3", "$.cloths[0].tethers", "3 has the wrong type"},
       {"/cloths/0/tethers/scale", "0", "$.cloths[0].tethers.scale", "0 is out of range"},
       {"/cloths/0/tethers/scale", "-1", "$.cloths[0].tethers.scale", "-1 is out of range"},
       {"/cloths/0/tethers/scale", "\"1\"", "$.cloths[0].tethers.scale", "\"1\" has the"},
       {"/cloths/0/tethers/compliance", "-0.5", "$.cloths[0].tethers.compliance",
        "-0.5 is out of range"},
       {"/cloths/0/tethers/complience", "1", "$.cloths[0].tethers.complience", "unknown key"}});
}

}  // namespace
}  // namespace weft::io::test
