#include "api/context/slots.h"

#include <algorithm>
#include <memory>
#include <random>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "base/stable_sort_host.h"
#include "weft/core.hpp"

namespace weft {

TEST(Slots, GiveNoIdTwiceInWorldsThatShareTheNumbers) {
  const auto numbers = std::make_unique<api::IdNumbers>();
  std::set<std::pair<uint32_t, uint32_t>> seen;
  for (int world = 0; world < 50; ++world) {
    api::Slots<ClothId> slots(*numbers);
    Vector<int> records;
    for (int life = 0; life < 20; ++life) {
      const ClothId id = slots.take(records);
      ASSERT_TRUE(id);
      ASSERT_TRUE(seen.insert({id.index, id.generation}).second);
      if (life % 2 == 0) slots.give_back(id.index);
    }
  }
}

TEST(Slots, RetireOneWhoseNumbersAreUsedUpAndRefuseWhenAllAre) {
  const auto numbers = std::make_unique<api::IdNumbers>(~0u - 1);  // one is left of each
  api::Slots<ClothId> slots(*numbers);
  Vector<char> records;
  std::set<uint32_t> seen;
  for (uint32_t i = 0; i < api::IdNumbers::slots; ++i) {
    const ClothId id = slots.take(records);
    ASSERT_EQ(id.generation, ~0u);
    ASSERT_TRUE(seen.insert(id.index).second);
    slots.give_back(id.index);
  }
  EXPECT_THROW(slots.take(records), InvalidInput);
  EXPECT_THROW(slots.take(records), InvalidInput);
}

TEST(StableSort, KeepsTheOrderOfWhatIsAlike) {
  std::mt19937 random(7);
  for (const size_t count : {0u, 1u, 2u, 15u, 16u, 17u, 33u, 100u, 1000u, 4097u}) {
    Vector<std::pair<uint32_t, size_t>> values;
    for (size_t i = 0; i < count; ++i) values.push_back({uint32_t(random() % 10), i});
    auto expected = values;
    const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(expected.begin(), expected.end(), before);
    weft::stable_sort(values.begin(), values.end(), before);
    EXPECT_EQ(values, expected) << count;
  }
}

TEST(Text, IsCutWhereItIsTooLong) {
  const std::string words(2000, 'w');
  EXPECT_EQ(std::string(text("%s", words.c_str()).c_str()), words.substr(0, 511));
}

}  // namespace weft
