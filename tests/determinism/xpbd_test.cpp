// Springs as constraints on sheets so large that threads share each colour: the same bits on any
// number of threads, with and without a small cloth beside.
#include "reference/sheets.h"

namespace weft_tests {
namespace {

class LargeXpbd : public BothPrecisions {
 protected:
  /// After 40 substeps of a sheet that hangs by two corners and is pushed aside.
  uint64_t hash(uint32_t threads, bool with_ladder, bool with_another) const {
    weft::ContextDesc context = TestWorld::one_thread();
    context.threads = threads;
    weft::WorldDesc desc = plain_world(GetParam());
    desc.integrator = weft::Integrator::xpbd;
    desc.gravity = {0, 0, -9.81};
    desc.substeps = 10;
    desc.ladder[0] = with_ladder ? 8 : 0;
    desc.ladder[1] = with_ladder ? 4 : 0;
    TestWorld test(desc, context);
    Sheet large;
    large.rows = 131;
    large.columns = 263;  // one thread sweeps over its rows
    large.noise = 0.001;
    large.pins = {0, 262};
    weft::ClothDesc cloth;
    cloth.velocity = {0.5, 0, 0.1};
    large.add_to(test, cloth);
    if (with_another) Sheet{}.add_network_to(test);
    test.step(1.0 / 60, 4);
    return test.hash();
  }
};

TEST_P(LargeXpbd, HasTheBitsOfOneThread) {
  for (const bool with_ladder : {false, true}) {
    for (const bool with_another : {false, true}) {
      const uint64_t one = hash(1, with_ladder, with_another);
      for (const uint32_t threads : {2u, 3u, 5u}) {
        EXPECT_EQ(hash(threads, with_ladder, with_another), one)
            << threads << " threads" << (with_ladder ? ", long springs" : "");
      }
    }
  }
}
TEST_P(LargeXpbd, LongSpringsChangeTheMotion) {
  EXPECT_NE(hash(1, true, false), hash(1, false, false));
}

INSTANTIATE_TEST_SUITE_P(Precisions, LargeXpbd, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
