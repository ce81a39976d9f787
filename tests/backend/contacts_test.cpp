// Self-collision where the host cannot look at a frame before it is over, as on a GPU: lists of
// near pairs are planned before, and a frame that has outrun one is made again. Same bits as where
// it can look.
#include <gtest/gtest.h>

#include "api/context/context_state.h"
#include "api/world/state.h"
#include "backends.h"

namespace weft::testing::contacts {
namespace {

constexpr int frames = 40;
constexpr uint32_t substeps = 16;

struct Case {
  Precision precision;
  Form form;
  PairSearch search;
  double distance = 0.025;  ///< with 0.07 a list needs more room than it has at first
};

/// A sheet that falls onto a plane and a ball and folds there, with a smaller one above it that
/// sleeps until it is hit.
World folding_sheet(Context& context, const Case& c) {
  WorldDesc desc;
  desc.precision = c.precision;
  desc.form = c.form;
  desc.substeps = substeps;
  World world = std::move(*context.create_world(desc));
  for (const uint32_t side : {28u, 9u}) {
    GridDesc grid;
    grid.rows = grid.columns = side;
    grid.width = grid.height = 0.03 * (side - 1);
    grid.material.stiffness = 40;
    ClothDesc cloth;
    cloth.fabric = *context.cook(grid);
    cloth.pose.degrees = side == 9 ? 10 : 75;
    cloth.pose.translate = {side == 9 ? 0.2 : 0, side == 9 ? 1.2 : 0.5, side == 9 ? 0.2 : 0};
    cloth.drag = 1e-4;
    const Pin pin{40, 0};
    PinMotion motion;
    motion.amplitude = {0.1, 0, 0.2};
    motion.omega = 8;
    if (side == 9) {
      cloth.pins = View<Pin>(&pin, 1);
      cloth.motions = View<PinMotion>(&motion, 1);
    }
    EXPECT_TRUE(world.create_cloth(cloth));
  }
  PlaneDesc plane;
  plane.offset = 0;
  plane.friction = 0.4;
  EXPECT_TRUE(world.create_plane(plane));
  SphereDesc ball;
  ball.center = {0.4, 0.2, 0.1};
  ball.radius = 0.15;
  EXPECT_TRUE(world.create_sphere(ball));
  SelfCollisionDesc collision;
  collision.search = c.search;
  collision.distance = c.distance;
  collision.friction = 0.2;
  collision.cell = 0.06;
  EXPECT_EQ(world.set_self_collision(collision), Status::ok);
  return world;
}

struct Outcome {
  std::vector<uint64_t> hashes;
  std::vector<uint64_t> lists;  ///< made in each frame; only where it is `counted`
};

Outcome run(const Backend& backend, const Case& c, uint32_t threads, bool counted = false) {
  auto state = std::make_shared<api::ContextState>(ContextDesc{});
  state->backend = &backend;
  state->threads = threads;
  Context context(new Context::Impl{state});
  World world = folding_sheet(context, c);
  Outcome out;
  uint64_t before = 0;
  for (int frame = 0; frame < frames; ++frame) {
    EXPECT_EQ(world.step(1.0 / 60), Status::ok);
    out.hashes.push_back(*world.state_hash());
    if (!counted) continue;
    const uint64_t lists = world.contacts()->lists;  // which makes one itself
    out.lists.push_back(lists - 1 - before);
    before = lists;
  }
  return out;
}

class Contacts : public ::testing::TestWithParam<Case> {};

TEST_P(Contacts, AFoldingSheetHasTheSameBitsOnEveryBackend) {
  const auto& all = backends();
  const Outcome expected = run(*all.back().backend, GetParam(), 1);
  for (const NamedBackend& other : all) {
    EXPECT_EQ(run(*other.backend, GetParam(), 2).hashes, expected.hashes) << other.name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Contacts,
    ::testing::Values(Case{Precision::float32, Form::summed, PairSearch::complete},
                      Case{Precision::float32, Form::position, PairSearch::complete},
                      Case{Precision::float64, Form::summed, PairSearch::complete},
                      Case{Precision::float64, Form::position, PairSearch::complete},
                      Case{Precision::float32, Form::summed, PairSearch::complete, 0.07},
                      Case{Precision::float32, Form::position, PairSearch::complete, 0.07},
                      Case{Precision::float32, Form::summed, PairSearch::staggered},
                      Case{Precision::float32, Form::summed, PairSearch::staggered, 0.07}));

/// Lists that outlive their substep, and frames that were made again with one in each.
TEST(PlannedLists, LastAndAreOutrun) {
  const Case c{Precision::float32, Form::summed, PairSearch::complete};
  const NamedBackend& split = backends().front();
  ASSERT_EQ(split.name, "omp_aos4");
  const Outcome counted = run(*split.backend, c, 1, true);
  int few = 0, again = 0;
  for (const uint64_t lists : counted.lists) {
    few += lists <= substeps / 4;
    again += lists > substeps;
  }
  EXPECT_GE(few, 5);
  EXPECT_GE(again, 1);
  EXPECT_EQ(counted.hashes, run(*split.backend, c, 2).hashes) << "a list's age changes a bit";
}

}  // namespace
}  // namespace weft::testing::contacts
