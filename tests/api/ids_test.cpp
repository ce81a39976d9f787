// Ids are never used twice, and objects that come and go leave no growth.
#include <set>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

TEST(Ids, AreNotUsedTwiceInTwoHundredThousandLives) {
  TestWorld test;
  std::set<std::pair<uint32_t, uint32_t>> seen;
  for (int i = 0; i < 200000; ++i) {
    const weft::ColliderId id = test.take(test.world().create_sphere({}));
    ASSERT_TRUE(seen.insert({id.index, id.generation}).second) << i;
    test.check(test.world().destroy_collider(id));
  }
  EXPECT_LE(seen.rbegin()->first, 4u);
}

TEST(Ids, TenThousandClothsComeAndGoWithoutGrowth) {
  TestWorld test;
  weft::GridDesc grid;
  grid.rows = grid.columns = 4;
  weft::ClothDesc cloth;
  cloth.fabric = test.cook(grid);
  uint64_t bytes = 0;
  for (int round = 0; round < 10; ++round) {
    std::vector<weft::ClothId> ids;
    for (int i = 0; i < 1000; ++i) ids.push_back(test.add(cloth));
    test.step(1.0 / 60);
    for (const weft::ClothId id : ids) test.check(test.world().destroy_cloth(id));
    for (const weft::ClothId id : ids) ASSERT_FALSE(test.world().valid(id));
    test.step(1.0 / 60);
    if (round == 0) bytes = test.context().bytes_allocated();
    EXPECT_LE(test.context().bytes_allocated(), bytes) << round;
  }
}

}  // namespace
}  // namespace weft_tests
