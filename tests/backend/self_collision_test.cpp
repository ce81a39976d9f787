// Self-collision on every back end and memory layout, with passes fused and apart.
#include <gtest/gtest.h>

#include "api/context/context_state.h"
#include "api/world/state.h"
#include "backends.h"

namespace weft::testing::self_collision {
namespace {

Context contact_context(const Backend& backend, uint32_t threads) {
  auto state = std::make_shared<api::ContextState>(ContextDesc{});
  state->backend = &backend;
  state->threads = threads;
  return Context(new Context::Impl{state});
}

/// Two sheets, one with a moving pin, that fall onto each other, a ball and the ground.
struct FallingSheets {
  Precision precision;
  Form form;
  SelfCollisionDesc contact;

  uint64_t hash_on(const Backend& backend, uint32_t threads) const {
    Context context = contact_context(backend, threads);
    WorldDesc desc;
    desc.precision = precision;
    desc.form = form;
    World world = std::move(*context.create_world(desc));
    EXPECT_EQ(world.set_self_collision(contact), Status::ok);
    GridDesc grid;
    grid.rows = 17;
    grid.columns = 23;
    grid.width = grid.height = 0.4;
    grid.material.mass.value = 0.1;
    for (int layer = 0; layer < 2; ++layer) {
      const Pin pin{0, 0};
      PinMotion motion;
      motion.amplitude = {0.02, 0.05, 0.1};
      motion.omega = 7;
      ClothDesc cloth;
      cloth.fabric = *context.cook(grid);
      cloth.pose = {{1, 0.1 * layer, 0}, 80, {-0.2 + 0.03 * layer, 0.12 + 0.02 * layer, -0.2}};
      if (layer == 1) {
        cloth.pins = View<Pin>(&pin, 1);
        cloth.motions = View<PinMotion>(&motion, 1);
        cloth.collision_distance = 0.02;
      }
      EXPECT_TRUE(world.create_cloth(cloth));
    }
    SphereDesc sphere;
    sphere.radius = 0.1;
    sphere.friction = 0.2;
    EXPECT_TRUE(world.create_sphere(sphere));
    PlaneDesc plane;
    plane.offset = -0.05;
    EXPECT_TRUE(world.create_plane(plane));
    uint64_t hash = 0, touched = 0;
    for (int frame = 0; frame < 18; ++frame) {
      EXPECT_EQ(world.step(1.0 / 60), Status::ok);
      hash = 31 * hash + *world.state_hash();
      if (frame % 5 == 4) touched += world.contacts()->touching;
    }
    EXPECT_GT(touched, 0u);
    return 31 * hash + touched;
  }
};

TEST(SelfCollisionLayout, NoLayoutLevelOrThreadCountChangesABit) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Form form : {Form::summed, Form::position}) {
      for (const PairSearch search : {PairSearch::complete, PairSearch::staggered}) {
        SelfCollisionDesc contact;
        contact.search = search;
        contact.distance = 0.015;
        contact.friction = 0.3;
        contact.cell = 0.04;
        contact.window = 8;
        const FallingSheets scene{precision, form, contact};
        const uint64_t expected = scene.hash_on(*backends()[0].backend, 1);
        for (const NamedBackend& other : backends()) {
          for (const uint32_t threads : {1u, 3u}) {
            EXPECT_EQ(scene.hash_on(*other.backend, threads), expected)
                << other.name << " " << threads << " threads " << to_string(precision) << " "
                << int(form) << " " << int(search);
          }
        }
      }
    }
  }
}

/// On each, a list that is kept has the bits of one that is made anew.
TEST(SelfCollisionLayout, NoSkinChangesABit) {
  for (const NamedBackend& each : backends()) {
    for (const Form form : {Form::summed, Form::position}) {
      SelfCollisionDesc contact;
      contact.distance = 0.015;
      contact.skin = 0;
      const uint64_t expected =
          FallingSheets{Precision::float32, form, contact}.hash_on(*each.backend, 2);
      for (const double skin : {-1.0, 0.01}) {
        contact.skin = skin;
        EXPECT_EQ((FallingSheets{Precision::float32, form, contact}.hash_on(*each.backend, 2)),
                  expected)
            << each.name << " " << skin;
      }
    }
  }
}

}  // namespace
}  // namespace weft::testing::self_collision
