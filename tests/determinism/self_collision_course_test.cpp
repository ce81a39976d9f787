// What happens between steps does not part the bits of a list that is kept from those of one that
// is made anew in every substep.
#include "reference/effects.h"
#include "reference/random.h"

#include <functional>
#include <tuple>

namespace weft_tests::self_collision_course {
namespace {

enum class Course { uneven, advance, halves, rebuilt, walks, pushed, changed };
constexpr Course every_course[] = {Course::uneven, Course::advance, Course::halves, Course::rebuilt,
                                   Course::walks,  Course::pushed,  Course::changed};
const char* name(Course course) {
  const char* const names[] = {"uneven", "advance", "halves", "rebuilt",
                               "walks",  "pushed",  "changed"};
  return names[int(course)];
}

weft::SelfCollisionDesc contact_with(double skin) {
  weft::SelfCollisionDesc desc;
  desc.distance = 0.02;
  desc.friction = 0.3;
  desc.skin = skin;
  return desc;
}

/// A sheet that is folded in two, its upper half a little above the lower.
weft::ClothId add_folded(TestWorld& test, Vec at, weft::ClothDesc cloth = {}) {
  constexpr uint32_t rows = 15, columns = 9;
  weft::GridDesc grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.height = 0.42;
  grid.width = 0.24;
  grid.material.stiffness = {40, 20, 0.2};
  grid.material.mass.value = 0.05;
  std::vector<weft::double3> x;
  for (uint32_t r = 0; r < rows; ++r)
    for (uint32_t c = 0; c < columns; ++c) {
      const double along = 0.03 * (r < 8 ? r : 14 - r), up = r < 8 ? 0.003 * r : 0.055 - 0.001 * r;
      x.push_back(to_weft(at + Vec{0.03 * c, up, along + (r < 8 ? 0 : 0.011)}));
    }
  cloth.positions = weft::View<weft::double3>(x);
  cloth.drag = 1e-4;
  return test.add(grid, cloth);
}

struct Walked {
  std::vector<uint64_t> hashes;
  uint64_t touched = 0;
  weft::ContactCounts counts;
};

Walked walk(Course course, weft::Precision precision, weft::Form form, double skin) {
  weft::WorldDesc desc;
  desc.precision = precision;
  desc.form = form;
  desc.fixed_dt = 1.0 / 90;
  TestWorld test(desc);
  weft::World& world = test.world();
  test.check(world.set_self_collision(contact_with(skin)));
  weft::ClothDesc pinned;
  const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {8, weft::Pin::fixed}};
  if (course == Course::walks) pinned.pins = pins;
  const weft::ClothId sheet = add_folded(test, {0, 0.02, 0}, pinned);
  weft::ClothId guest{};
  const weft::ColliderId floor = add_body(test, Body::plane, {0, 0, 0}, 1, 0.4);
  weft::ColliderId ball{};
  reference::SplitMix random(12);
  Walked walked;
  for (int frame = 0; frame < 36; ++frame) {
    double dt = 1.0 / 60;
    if (course == Course::uneven) dt = frame % 7 == 3 ? 0 : 0.004 + 0.03 * random.uniform();
    if (course == Course::rebuilt) {
      if (frame == 8) guest = add_folded(test, {0.05, 0.12, 0.03});
      if (frame == 14) ball = add_body(test, Body::sphere, {0.1, 0.05, 0.1}, 0.04, 0.2);
      if (frame == 20) test.check(world.destroy_cloth(guest));
      if (frame == 24) test.check(world.destroy_collider(ball));
      if (frame == 28) test.check(world.destroy_collider(floor));
    }
    if (course == Course::walks) {  // ever faster, 65 m
      const std::vector<uint32_t> vertices{0, 8};
      const double x = 0.05 * (frame + 1) * (frame + 1);
      const std::vector<weft::double3> to{{x, 0.02, 0}, {x + 0.24, 0.02, 0}};
      test.check(world.move_pins(sheet, vertices, weft::View<weft::double3>(to)));
    }
    if (course == Course::pushed) {
      if (frame % 5 == 1) {
        const weft::VertexForce force{uint32_t(7 * frame) % 135, {0, 0.3, -0.2}};
        test.check(world.set_forces(sheet, weft::View<weft::VertexForce>(&force, 1)));
      }
      if (frame == 6) test.check(world.set_gravity({3, -2, 1}));
      if (frame == 12) {
        weft::WindDesc wind;
        wind.velocity = {4, -6, 0};
        test.check(world.set_wind(wind));
      }
      if (frame == 22) test.check(world.clear_wind());
    }
    if (course == Course::changed) {
      weft::SelfCollisionDesc other = contact_with(skin);
      if (frame == 9) other.distance = 0.026;
      if (frame == 15) other.friction = 0;
      if (frame == 21) other.search = weft::PairSearch::staggered;
      if (frame == 30) test.check(world.clear_self_collision());
      if (frame % 3 == 0) test.check(world.set_self_collision(other));
    }
    if (course == Course::advance) {
      test.take(world.advance(frame % 4 == 0 ? 1.0 / 144 : 1.0 / 50));
    } else if (course == Course::halves && frame % 2 == 1) {
      test.check(world.begin_step(dt));
      test.check(world.end_step());
    } else {
      test.step(dt);
    }
    walked.hashes.push_back(test.hash());
    if (frame % 6 == 0) {
      walked.counts = test.take(world.contacts());
      walked.touched += walked.counts.touching;
    }
  }
  return walked;
}

class SelfCollisionCourse
    : public testing::TestWithParam<std::tuple<Course, weft::Precision, weft::Form>> {};

TEST_P(SelfCollisionCourse, HasTheBitsOfAListMadeAnew) {
  const auto [course, precision, form] = GetParam();
  const Walked anew = walk(course, precision, form, 0);
  EXPECT_GT(anew.touched, 0u) << "nothing is tried";
  for (const double skin : {-1.0, 0.004, 0.02}) {
    const Walked kept = walk(course, precision, form, skin);
    for (size_t f = 0; f < anew.hashes.size(); ++f)
      ASSERT_EQ(kept.hashes[f], anew.hashes[f]) << "frame " << f << ", skin " << skin;
    EXPECT_EQ(kept.touched, anew.touched);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, SelfCollisionCourse,
                         testing::Combine(testing::ValuesIn(every_course), both_precisions(),
                                          testing::Values(weft::Form::summed,
                                                          weft::Form::position)),
                         [](const auto& info) {
                           return std::string(name(std::get<0>(info.param))) + "_" +
                                  weft::to_string(std::get<1>(info.param)) +
                                  (std::get<2>(info.param) == weft::Form::summed ? "_summed"
                                                                                 : "_position");
                         });

/// Reading between steps is reading.
TEST(SelfCollisionReads, ChangeNoBit) {
  for (const double skin : {-1.0, 0.0}) {
    uint64_t hashes[2];
    for (const bool reads : {false, true}) {
      TestWorld test;
      test.check(test.world().set_self_collision(contact_with(skin)));
      add_body(test, Body::plane, {0, 0, 0}, 1, 0.4);
      const weft::ClothId sheet = add_folded(test, {0, 0.02, 0});
      for (int frame = 0; frame < 25; ++frame) {
        test.step(1.0 / 60);
        if (!reads) continue;
        test.take(test.world().contacts());
        test.take(test.world().near_pairs(frame % 2 == 0));
        test.velocities(sheet);
        test.mechanics();
      }
      hashes[reads] = test.hash();
    }
    EXPECT_EQ(hashes[0], hashes[1]) << skin;
  }
}

/// A cloth added later does not change the order in which the others meet: nor does one that has
/// gone.
TEST(SelfCollisionReads, ACommonPastIsForgotten) {
  uint64_t hashes[2];
  for (const bool with : {false, true}) {
    TestWorld test;
    test.check(test.world().set_self_collision(contact_with(-1)));
    add_body(test, Body::plane, {0, 0, 0}, 1, 0.4);
    weft::ClothId far{};
    if (with) far = add_folded(test, {50, 3, 0});
    add_folded(test, {0, 0.02, 0});
    add_folded(test, {0.05, 0.09, 0.02});
    for (int frame = 0; frame < 24; ++frame) {
      test.step(1.0 / 60);
      if (with && frame == 11) test.check(test.world().destroy_cloth(far));
    }
    hashes[with] = test.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace weft_tests::self_collision_course
