// Self-collision has the same bits whatever the list's skin, the threads, the level and the way in
// which forces are added up.
#include "determinism/levels.h"
#include "reference/effects.h"
#include "reference/random.h"

#include <functional>
#include <tuple>

namespace weft_tests::self_collision_bits {
namespace {

constexpr double dt = 1.0 / 60;

enum class Meeting { folds, skirt, stack, apart, fast, explodes, tangle };
constexpr Meeting every_meeting[] = {Meeting::folds, Meeting::skirt, Meeting::stack,
                                     Meeting::apart, Meeting::fast,  Meeting::explodes,
                                     Meeting::tangle};
const char* name(Meeting meeting) {
  const char* const names[] = {"folds", "skirt", "stack", "apart", "fast", "explodes", "tangle"};
  return names[int(meeting)];
}
/// Frames that a scene is followed for.
int frames_of(Meeting meeting) {
  const int frames[] = {40, 12, 24, 12, 12, 10, 20};
  return frames[int(meeting)];
}

weft::GridDesc small_sheet(uint32_t n, double size) {
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.width = grid.height = size;
  grid.material.stiffness = {60, 20, 0.5};
  grid.material.mass.value = 0.1;
  return grid;
}

/// A sheet that slides off a ball, folds onto itself on the ground, in the wind.
void add_folding_sheet(TestWorld& test) {
  add_body(test, Body::sphere, {0.12, 0.25, 0.08}, 0.12, 0.2);
  add_body(test, Body::plane, {0, 0, 0}, 1, 0.3);
  weft::WindDesc wind;
  wind.velocity = {1, 0, 0.5};
  test.check(test.world().set_wind(wind));
  weft::ClothDesc cloth;
  cloth.pose = {{1, 0, 0}, 84, {-0.25, 0.32, -0.22}};
  cloth.drag = 1e-4;
  test.add(small_sheet(24, 0.5), cloth);
}

/// Two layers round a capsule that turns, held by tethers; pins that move.
weft::ColliderId add_skirt(TestWorld& test) {
  const weft::ColliderId body = add_body(test, Body::capsule, {0, 0, 0}, 0.15, 0.4);
  const std::vector<weft::PinMotion> motions{{{0, 0.1, 0}, {0.03, 0, 0.04}, 11}};
  for (int layer = 0; layer < 2; ++layer) {
    const std::vector<weft::Pin> pins{{0, layer == 0 ? 0 : weft::Pin::fixed},
                                      {19, weft::Pin::fixed}};
    weft::ClothDesc cloth;
    cloth.pose = {{1, 0, 0}, 90, {-0.2, 0.01 + 0.015 * layer, -0.2}};
    cloth.pins = pins;
    cloth.motions = motions;
    cloth.tether_scale = 1.05;
    cloth.spring_damping = 1e-3;
    test.add(small_sheet(20, 0.4), cloth);
  }
  return body;
}

/// Three sheets on the floor, one of them asleep soon, one of another distance.
void add_stack(TestWorld& test) {
  add_body(test, Body::plane, {0, 0, 0}, 1, 0.5);
  for (int layer = 0; layer < 3; ++layer) {
    weft::ClothDesc cloth;
    cloth.pose = {{1, 0, 0}, 90, {0.013 * layer, 0.001 + 0.03 * layer * layer, 0.007 * layer}};
    cloth.drag = 1e-3;
    cloth.sleep_speed = 0.05;
    cloth.sleep_time = 0.1;
    cloth.collision_distance = layer == 1 ? 0.02 : 0;
    test.add(small_sheet(14, 0.3), cloth);
  }
}

/// 5 km from the origin, two cloths whose own origins differ.
void add_far_cloths(TestWorld& test) {
  for (int layer = 0; layer < 2; ++layer) {
    weft::ClothDesc cloth;
    cloth.pose = {{1, 0, 0}, 90, {5000 + 0.21 * layer, -3000 + 0.03 * layer, 4000}};
    cloth.velocity = {0, layer == 0 ? 0.5 : -0.5, 0.1};
    test.add(small_sheet(18 + uint32_t(layer), 0.35), cloth);
  }
}

/// At 100 m/s together, and slowly towards each other.
void add_fast_cloths(TestWorld& test) {
  for (int layer = 0; layer < 2; ++layer) {
    weft::ClothDesc cloth;
    cloth.pose = {{1, 0, 0}, 90 - 10.0 * layer, {0.04 * layer, 0.05 * layer, 0}};
    cloth.velocity = {100, layer == 0 ? 0.6 : -0.3, -40};
    test.add(small_sheet(18, 0.35), cloth);
  }
}

/// Stiffer than its steps allow, above one that is not.
void add_exploding_cloth(TestWorld& test) {
  weft::GridDesc stiff = small_sheet(12, 0.3);
  stiff.material.stiffness = 900;
  std::vector<weft::double3> x;
  reference::SplitMix random(3);
  for (int i = 0; i < 144; ++i) {
    x.push_back(to_weft(Vec{0.3 * (i % 12) / 11, 0.4, 0.3 * (i / 12) / 11} + random.noise(2e-3)));
  }
  weft::ClothDesc cloth;
  cloth.positions = weft::View<weft::double3>(x);
  test.add(stiff, cloth);
}

/// Free particles and springs in a heap, with a hub.
void add_tangle(TestWorld& test) {
  add_body(test, Body::box, {0, -0.15, 0}, 0.1, 0.2);
  reference::SplitMix random(9);
  NetworkParts parts;
  for (uint32_t i = 0; i < 500; ++i) {
    parts.positions.push_back(random.noise(0.6));
    parts.start.push_back(random.noise(0.15));
    parts.velocities.push_back(random.noise(1));
    parts.masses.push_back(0.001 + 0.002 * random.uniform());
    if (i > 0) parts.springs.push_back({i % 60 == 1 ? 0 : i / 3, i, 2, 0.05});
  }
  parts.pins = {1};
  add_network(test, parts);
}

struct Recipe {
  weft::WorldDesc world;
  weft::ContextDesc context = TestWorld::one_thread();
  weft::SelfCollisionDesc contact;
};

uint64_t hash_of(Meeting meeting, Recipe run, weft::ContactCounts* counts = nullptr) {
  if (meeting == Meeting::apart || meeting == Meeting::fast) run.world.gravity = {0, 0, 0};
  if (meeting == Meeting::explodes) {
    run.world.substeps = 4;
    run.world.unsafe = true;
  }
  TestWorld test(run.world, run.context);
  test.check(test.world().set_self_collision(run.contact));
  weft::ColliderId turning;
  if (meeting == Meeting::folds) add_folding_sheet(test);
  if (meeting == Meeting::skirt) turning = add_skirt(test);
  if (meeting == Meeting::stack) add_stack(test);
  if (meeting == Meeting::apart) add_far_cloths(test);
  if (meeting == Meeting::fast) add_fast_cloths(test);
  if (meeting == Meeting::explodes) {
    add_exploding_cloth(test);
    add_stack(test);
  }
  if (meeting == Meeting::tangle) add_tangle(test);
  uint64_t touched = 0, hash = 0;
  for (int frame = 1; frame <= frames_of(meeting); ++frame) {
    if (meeting == Meeting::skirt) {
      weft::Pose pose;
      pose.axis = {1, 0, 0};
      pose.degrees = 6 * frame;
      test.check(test.world().move_collider(turning, pose));
    }
    if (test.world().step(dt) != weft::Status::ok) break;  // it has exploded
    if (counts) touched += test.take(test.world().contacts()).touching;
    hash = 31 * hash + test.hash();
  }
  if (counts) {
    *counts = test.take(test.world().contacts());
    counts->touching = touched;
  }
  return hash;
}

class SelfCollisionBits
    : public testing::TestWithParam<std::tuple<Meeting, weft::Precision, weft::Form>> {
 protected:
  const Meeting meeting = std::get<0>(GetParam());

  Recipe recipe() const {
    Recipe run;
    run.world.precision = std::get<1>(GetParam());
    run.world.form = std::get<2>(GetParam());
    run.contact.distance = 0.015;
    run.contact.friction = 0.3;
    return run;
  }
};

/// From a list that is made anew in every substep.
TEST_P(SelfCollisionBits, DoNotDependOnTheSkin) {
  Recipe of = recipe();
  of.contact.skin = 0;
  weft::ContactCounts anew, kept;
  const uint64_t expected = hash_of(meeting, of, &anew);
  EXPECT_GT(anew.touching, 0u) << "nothing is tried";
  for (const double skin : {-1.0, 0.0075, 1e-4, 0.03}) {
    of.contact.skin = skin;
    EXPECT_EQ(hash_of(meeting, of, &kept), expected) << skin;
    const bool calm = meeting != Meeting::explodes && meeting != Meeting::tangle;
    if (skin == -1 && calm) {
      EXPECT_LT(kept.lists, anew.lists);
    }
  }
}

TEST_P(SelfCollisionBits, DoNotDependOnThreadsOrLevel) {
  if (!on_host()) GTEST_SKIP() << "of the host back end";
  for (const weft::PairSearch search : {weft::PairSearch::complete, weft::PairSearch::staggered}) {
    Recipe of = recipe();
    of.contact.search = search;
    of.contact.grids = 4;
    of.contact.window = 6;
    const uint64_t expected = hash_of(meeting, of);
    const bool complete = search == weft::PairSearch::complete;
    for (const uint32_t threads : complete ? std::vector{2u, 3u, 7u} : std::vector{3u}) {
      of.context.threads = threads;
      of.context.isa = levels()[threads % levels().size()];
      EXPECT_EQ(hash_of(meeting, of), expected)
          << threads << " threads, " << weft_tests::name(of.context.isa) << " " << int(search);
    }
  }
}

TEST_P(SelfCollisionBits, DoNotDependOnHowForcesAreAddedUp) {
  Recipe of = recipe();
  of.world.evaluation = weft::Evaluation::gather;
  const uint64_t gather = hash_of(meeting, of);
  of.world.evaluation = weft::Evaluation::scatter;
  EXPECT_EQ(hash_of(meeting, of), gather);
}

/// Reading, the pairs among it, changes nothing; friction and the distance do.
TEST_P(SelfCollisionBits, AreThoseOfThisDescriptionOnly) {
  Recipe of = recipe();
  const uint64_t expected = hash_of(meeting, of);
  of.contact.distance = 0.014;
  EXPECT_NE(hash_of(meeting, of), expected);
}

INSTANTIATE_TEST_SUITE_P(Every, SelfCollisionBits,
                         testing::Combine(testing::ValuesIn(every_meeting), both_precisions(),
                                          testing::Values(weft::Form::summed,
                                                          weft::Form::position)),
                         [](const auto& info) {
                           return std::string(name(std::get<0>(info.param))) + "_" +
                                  weft::to_string(std::get<1>(info.param)) +
                                  (std::get<2>(info.param) == weft::Form::summed ? "_summed"
                                                                                 : "_position");
                         });

/// A cloth that explodes elsewhere costs the other none of its bits.
TEST(SelfCollisionOfTwo, AnExplosionElsewhereChangesNoBit) {
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    std::vector<std::vector<Vec>> frames[2];
    double furthest = 0;
    for (const bool with : {false, true}) {
      weft::WorldDesc world;
      world.form = form;
      world.substeps = 6;
      world.unsafe = true;
      TestWorld test(world);
      weft::SelfCollisionDesc contact;
      contact.distance = 0.015;
      test.check(test.world().set_self_collision(contact));
      add_body(test, Body::plane, {0, 0, 0}, 1, 0.3);
      weft::ClothDesc cloth;
      cloth.pose = {{1, 0, 0}, 60, {0, 0.05, 0}};
      cloth.collision_layers = 1;
      const weft::ClothId good = test.add(small_sheet(16, 0.3), cloth);
      if (with) {
        weft::GridDesc stiff = small_sheet(12, 0.3);
        stiff.material.stiffness = 120;
        cloth.collision_layers = 2;
        cloth.pose.translate = {50, 3, 0};
        cloth.velocity = {0, 0, 1};
        test.add(stiff, cloth);
      }
      for (int frame = 0; frame < 30 && test.world().step(dt) == weft::Status::ok; ++frame) {
        frames[with].push_back(test.positions(good, 256));
        if (with) furthest = test.mechanics().stretch;
      }
    }
    EXPECT_GT(furthest, 100) << "it does not explode";
    ASSERT_GE(frames[1].size(), 4u);
    for (size_t f = 0; f < frames[1].size(); ++f) {
      size_t others = 0;
      for (size_t i = 0; i < 256; ++i) others += !same_bits(frames[0][f][i], frames[1][f][i]);
      EXPECT_EQ(others, 0u) << "frame " << f;
    }
  }
}

}  // namespace
}  // namespace weft_tests::self_collision_bits
