// Every field of the cloth description, and every call on a cloth, with an impossible value (HC25).
#include "reference/refusals.h"
#include "reference/networks.h"

#include <functional>

namespace weft_tests {
namespace {

/// A world with one cloth that has moved, and the fabric for more.
class BadCloth : public testing::Test {
 protected:
  BadCloth() {
    weft::GridDesc grid;
    grid.rows = grid.columns = 3;
    fabric = test.cook(grid);
    weft::ClothDesc desc;
    desc.fabric = fabric;
    desc.pins = pins;
    cloth = test.add(desc);
    test.step(0.01, 3);
  }

  weft::ClothDesc good() const {
    weft::ClothDesc desc;
    desc.fabric = fabric;
    return desc;
  }
  void expect_refused(const weft::ClothDesc& desc, const std::vector<std::string>& words) {
    expect_refused_unchanged(test, words, [&] { return test.world().create_cloth(desc).status(); });
  }

  const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}};
  TestWorld test;
  weft::Fabric fabric;
  weft::ClothId cloth;
};

TEST_F(BadCloth, ScalarsAreChecked) {
  struct Field {
    const char* name;
    std::function<void(weft::ClothDesc&, double)> set;
    std::vector<double> values;
  };
  const std::vector<Field> fields{
      {"axis", [](weft::ClothDesc& d, double v) { d.pose.axis.x = v; }, not_finite},
      {"axis", [](weft::ClothDesc& d, double v) { d.pose.axis.y = v; }, not_finite},
      {"axis", [](weft::ClothDesc& d, double v) { d.pose.axis.z = v; }, not_finite},
      {"axis",
       [](weft::ClothDesc& d, double v) {
         d.pose.axis = {0, 0, 0}, d.pose.degrees = v;
       },
       {30}},
      {"degrees", [](weft::ClothDesc& d, double v) { d.pose.degrees = v; }, not_finite},
      {"translate", [](weft::ClothDesc& d, double v) { d.pose.translate.x = v; }, not_finite},
      {"translate", [](weft::ClothDesc& d, double v) { d.pose.translate.y = v; }, not_finite},
      {"translate", [](weft::ClothDesc& d, double v) { d.pose.translate.z = v; }, not_finite},
      {"velocity", [](weft::ClothDesc& d, double v) { d.velocity.x = v; }, not_finite},
      {"velocity", [](weft::ClothDesc& d, double v) { d.velocity.y = v; }, not_finite},
      {"velocity", [](weft::ClothDesc& d, double v) { d.velocity.z = v; }, not_finite},
      {"drag", [](weft::ClothDesc& d, double v) { d.drag = v; }, negative},
      {"spring_damping", [](weft::ClothDesc& d, double v) { d.spring_damping = v; }, negative},
      {"collision_distance", [](weft::ClothDesc& d, double v) { d.collision_distance = v; },
       negative},
      {"collides_itself",
       [](weft::ClothDesc& d, double v) { d.collides_itself = uint8_t(v); },
       {2, 255}},
      {"collides_others",
       [](weft::ClothDesc& d, double v) { d.collides_others = uint8_t(v); },
       {2, 255}},
      {"drag_model",
       [](weft::ClothDesc& d, double v) { d.drag_model = weft::DragModel(int(v)); },
       {7}},
  };
  for (const Field& field : fields)
    for (double value : field.values) {
      SCOPED_TRACE(std::string(field.name) + " = " + std::to_string(value));
      weft::ClothDesc bad = good();
      field.set(bad, value);
      expect_refused(bad, {field.name});
    }
}

TEST_F(BadCloth, PositionsAndVelocitiesAreChecked) {
  for (double value : not_finite) {
    std::vector<weft::double3> points(9, {0, 0, 0});
    points[4].y = value;
    weft::ClothDesc bad = good();
    bad.positions = weft::View<weft::double3>(points);
    expect_refused(bad, {"positions", "4"});
    bad = good();
    bad.velocities = points;
    expect_refused(bad, {"velocities", "4"});
  }
  const std::vector<weft::double3> few(8, {0, 0, 0});
  weft::ClothDesc bad = good();
  bad.positions = weft::View<weft::double3>(few);
  expect_refused(bad, {"positions", "8", "9"});
  bad = good();
  bad.velocities = few;
  expect_refused(bad, {"velocities", "8", "9"});
}

TEST_F(BadCloth, PinsAreChecked) {
  const std::vector<weft::PinMotion> motions(2);
  const std::vector<weft::Pin> beyond{{0, weft::Pin::fixed}, {9, weft::Pin::fixed}};
  const std::vector<weft::Pin> twice{{3, weft::Pin::fixed}, {4, 0}, {3, 1}};
  const std::vector<weft::Pin> no_motion{{3, 2}};
  weft::ClothDesc bad = good();
  bad.motions = motions;
  bad.pins = beyond;
  expect_refused(bad, {"pin", "9"});
  bad.pins = twice;
  expect_refused(bad, {"pin", "3"});
  bad.pins = no_motion;
  expect_refused(bad, {"motion", "2"});
}

TEST_F(BadCloth, MotionsAreChecked) {
  const std::vector<weft::Pin> pin{{0, 1}};
  for (double value : not_finite)
    for (int field = 0; field < 7; ++field) {
      std::vector<weft::PinMotion> motions(2);
      weft::PinMotion& m = motions[1];
      double* values[] = {&m.velocity.x,  &m.velocity.y,  &m.velocity.z, &m.amplitude.x,
                          &m.amplitude.y, &m.amplitude.z, &m.omega};
      *values[field] = value;
      weft::ClothDesc bad = good();
      bad.pins = pin;
      bad.motions = motions;
      expect_refused(bad, {field < 3 ? "velocity" : field < 6 ? "amplitude" : "omega", "1"});
    }
}

TEST_F(BadCloth, ForcesAreChecked) {
  const std::vector<weft::VertexForce> beyond{{0, {1, 0, 0}}, {9, {1, 0, 0}}};
  weft::ClothDesc bad = good();
  bad.forces = beyond;
  expect_refused(bad, {"force", "9"});
  for (double value : not_finite)
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<weft::VertexForce> forces{{0, {1, 0, 0}}, {5, {0, 0, 0}}};
      (axis == 0 ? forces[1].force.x : axis == 1 ? forces[1].force.y : forces[1].force.z) = value;
      bad.forces = forces;
      expect_refused(bad, {"force", "1"});
    }
}

TEST_F(BadCloth, StepsAreChecked) {
  for (double dt : {-0.01, -1e-300, not_a_number, infinity, -infinity, 1e-310, 4.9e-324}) {
    SCOPED_TRACE(dt);
    expect_refused_unchanged(test, {"dt"}, [&] { return test.world().step(dt); });
    expect_refused_unchanged(test, {"dt"}, [&] { return test.world().prepare(dt); });
    expect_refused_unchanged(test, {"dt"}, [&] { return test.world().substeps(dt).status(); });
  }
  test.step(0.01, 10);
  EXPECT_TRUE(all_finite(test.positions(cloth, 9)));
}

TEST_F(BadCloth, PinCallsAreChecked) {
  const std::vector<uint32_t> vertices{1, 9}, right{1, 2}, pin_and_beyond{0, 9}, free{1};
  const std::vector<weft::double3> targets{{0, 0, 0}, {1, 1, 1}}, one{{0, 0, 0}};
  const weft::View<weft::double3> two(targets);
  weft::World& world = test.world();
  expect_refused_unchanged(test, {"9"}, [&] { return world.move_pins(cloth, vertices, two); });
  expect_refused_unchanged(test, {"targets"}, [&] {
    return world.move_pins(cloth, right, weft::View<weft::double3>(one));
  });
  expect_refused_unchanged(test, {"9"}, [&] { return world.release_pins(cloth, pin_and_beyond); });
  expect_refused_unchanged(test, {"1"}, [&] { return world.release_pins(cloth, free); });
  for (double value : not_finite) {
    const std::vector<weft::double3> bad{{0, 0, 0}, {0, value, 0}};
    expect_refused_unchanged(test, {"target", "1"}, [&] {
      return world.move_pins(cloth, right, weft::View<weft::double3>(bad));
    });
  }
  test.step(0.01, 5);  // none of them left a trace
  TestWorld untouched;
  weft::GridDesc grid;
  grid.rows = grid.columns = 3;
  weft::ClothDesc desc;
  desc.pins = pins;
  untouched.add(grid, desc);
  untouched.step(0.01, 8);
  EXPECT_EQ(test.hash(), untouched.hash());
}

TEST_F(BadCloth, StaleAndNullIdsAreRefused) {
  weft::World& world = test.world();
  const weft::ClothId gone = test.add(good());
  test.check(world.destroy_cloth(gone));
  weft::double3 out[9];
  const std::vector<uint32_t> vertex{0};
  for (weft::ClothId id : {gone, weft::ClothId{}, weft::ClothId{77, 1}}) {
    EXPECT_FALSE(world.valid(id));
    EXPECT_EQ(world.destroy_cloth(id), weft::Status::invalid_handle);
    EXPECT_EQ(world.read_positions(id, out), weft::Status::invalid_handle);
    EXPECT_EQ(world.read_velocities(id, out), weft::Status::invalid_handle);
    EXPECT_EQ(world.read_accelerations(id, out), weft::Status::invalid_handle);
    EXPECT_EQ(world.release_pins(id, vertex), weft::Status::invalid_handle);
    EXPECT_EQ(world.stability(id).status(), weft::Status::invalid_handle);
  }
  const weft::ClothId successor = test.add(good());
  EXPECT_TRUE(world.valid(successor));
  EXPECT_FALSE(world.valid(gone));
  EXPECT_FALSE(successor == gone);
}

}  // namespace
}  // namespace weft_tests
