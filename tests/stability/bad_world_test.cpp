// Every field of the context, world and collider descriptions with an impossible value (HC25,
// HC54).
#include "reference/networks.h"
#include "reference/refusals.h"

#include <functional>

namespace weft_tests {
namespace {

std::string log_text;
weft::Log log_to_text() {
  log_text.clear();
  return {nullptr, [](void*, weft::Severity, const char* text) { log_text += text; }};
}

TEST(BadContext, OneOfTheTwoAllocatorFunctionsIsRefused) {
  weft::ContextDesc desc;
  desc.log = log_to_text();
  desc.allocator.allocate = [](void*, size_t, size_t) -> void* { return nullptr; };
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
  EXPECT_NE(log_text.find("allocat"), std::string::npos) << log_text;
}

TEST(BadContext, UnknownBackendAndLevelAreRefused) {
  weft::ContextDesc desc;
  desc.log = log_to_text();
  desc.backend = weft::BackendKind(77);
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
  EXPECT_NE(log_text.find("77"), std::string::npos) << log_text;
  desc = {};
  desc.log = log_to_text();
  desc.isa = weft::Isa(77);
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
  EXPECT_NE(log_text.find("77"), std::string::npos) << log_text;
}

TEST(BadContext, OtherBinaryLayoutIsRefused) {
  EXPECT_EQ(weft::Context::create({}, WEFT_ABI + 1).status(), weft::Status::version_mismatch);
}

TEST(BadContext, FailingAllocatorIsOutOfMemoryNotACrash) {
  weft::ContextDesc desc;
  desc.backend = weft::BackendKind::omp;  // a GPU's memory does not come from the allocator
  desc.allocator.allocate = [](void*, size_t, size_t) -> void* { return nullptr; };
  desc.allocator.deallocate = [](void*, void*, size_t) {};
  weft::Result<weft::Context> context = weft::Context::create(desc);
  if (!context) {
    EXPECT_EQ(context.status(), weft::Status::out_of_memory);
    return;
  }
  weft::Result<weft::World> world = context->create_world({});
  if (!world) {
    EXPECT_EQ(world.status(), weft::Status::out_of_memory);
    return;
  }
  weft::Result<weft::Fabric> fabric = context->cook(weft::GridDesc{});
  weft::Status status = fabric.status();
  if (fabric) {
    weft::ClothDesc cloth;
    cloth.fabric = *fabric;
    status = world->create_cloth(cloth).status();
    if (status == weft::Status::ok) status = world->prepare(0.01);
  }
  EXPECT_EQ(status, weft::Status::out_of_memory);
}

TEST(BadWorld, EveryFieldIsChecked) {
  TestWorld test;
  const auto refused = [&](const weft::WorldDesc& desc, const char* field) {
    test.clear_log();
    expect_refusal(test, test.context().create_world(desc).status(), {field});
  };
  for (double bad : not_finite)
    for (int axis = 0; axis < 3; ++axis) {
      weft::WorldDesc desc;
      (axis == 0 ? desc.gravity.x : axis == 1 ? desc.gravity.y : desc.gravity.z) = bad;
      refused(desc, "gravity");
    }
  for (double bad : {0.0, -0.5, 1.0000001, infinity, -infinity, not_a_number}) {
    weft::WorldDesc desc;
    desc.safety = bad;
    refused(desc, "safety");
  }
  weft::WorldDesc desc;
  desc.precision = weft::Precision(7);
  refused(desc, "precision");
  desc = {};
  desc.form = weft::Form(7);
  refused(desc, "form");
  desc = {};
  desc.start = weft::Start(7);
  refused(desc, "start");
}

TEST(BadWorld, GravityIsCheckedWhenItChanges) {
  TestWorld test;
  add_particles(test, {{0, 0, 0}});
  for (double bad : not_finite)
    expect_refused_unchanged(test, {"gravity"}, [&] {
      return test.world().set_gravity({0, bad, 0});
    });
}

TEST(BadSphere, EveryFieldIsChecked) {
  using Field = BadField<weft::SphereDesc>;
  const std::vector<Field> fields{
      {"center", [](weft::SphereDesc& d, double v) { d.center.x = v; }, not_finite},
      {"center", [](weft::SphereDesc& d, double v) { d.center.y = v; }, not_finite},
      {"center", [](weft::SphereDesc& d, double v) { d.center.z = v; }, not_finite},
      {"radius", [](weft::SphereDesc& d, double v) { d.radius = v; }, not_positive},
      {"velocity", [](weft::SphereDesc& d, double v) { d.velocity.x = v; }, not_finite},
      {"velocity", [](weft::SphereDesc& d, double v) { d.velocity.y = v; }, not_finite},
      {"velocity", [](weft::SphereDesc& d, double v) { d.velocity.z = v; }, not_finite},
      {"friction",
       [](weft::SphereDesc& d, double v) { d.friction = v; },
       {-1, infinity, not_a_number}},
  };
  TestWorld test;
  add_particles(test, {{0, 5, 0}});
  for (const Field& field : fields)
    for (double value : field.values) {
      SCOPED_TRACE(std::string(field.name) + " = " + std::to_string(value));
      expect_refused_unchanged(test, {field.name}, [&] {
        weft::SphereDesc bad;
        field.set(bad, value);
        return test.world().create_sphere(bad).status();
      });
    }
}

TEST(BadPlane, EveryFieldIsChecked) {
  using Field = BadField<weft::PlaneDesc>;
  const std::vector<Field> fields{
      {"normal", [](weft::PlaneDesc& d, double v) { d.normal.x = v; }, not_finite},
      {"normal", [](weft::PlaneDesc& d, double v) { d.normal.y = v; }, not_finite},
      {"normal", [](weft::PlaneDesc& d, double v) { d.normal.z = v; }, not_finite},
      {"normal",
       [](weft::PlaneDesc& d, double v) {
         d.normal = {v, v, v};
       },
       {0}},
      {"offset", [](weft::PlaneDesc& d, double v) { d.offset = v; }, not_finite},
      {"velocity", [](weft::PlaneDesc& d, double v) { d.velocity.x = v; }, not_finite},
      {"velocity", [](weft::PlaneDesc& d, double v) { d.velocity.y = v; }, not_finite},
      {"velocity", [](weft::PlaneDesc& d, double v) { d.velocity.z = v; }, not_finite},
      {"friction",
       [](weft::PlaneDesc& d, double v) { d.friction = v; },
       {-1, infinity, not_a_number}},
  };
  TestWorld test;
  add_particles(test, {{0, 5, 0}});
  for (const Field& field : fields)
    for (double value : field.values) {
      SCOPED_TRACE(std::string(field.name) + " = " + std::to_string(value));
      expect_refused_unchanged(test, {field.name}, [&] {
        weft::PlaneDesc bad;
        field.set(bad, value);
        return test.world().create_plane(bad).status();
      });
    }
}

TEST(BadStep, ACountOfSubstepsThatNobodyCouldRunIsRefusedAtOnce) {
  for (const double drag : {1e10, 1e18}) {
    TestWorld test;
    add_particles(test, {{0, 5, 0}}, {}, 1, drag, weft::DragModel::lagged);
    expect_refused_unchanged(test, {"substeps", "1e9"}, [&] { return test.world().step(1e3); });
    EXPECT_FALSE(test.world().substeps(1e15));
  }
}

TEST(BadIds, OfAnotherWorldNameNothing) {
  TestWorld first, second;
  const weft::ClothId a = add_particles(first, {{0, 5, 0}});
  const weft::ClothId b = add_particles(second, {{0, 5, 0}});
  EXPECT_NE(a, b);
  EXPECT_EQ(second.world().destroy_cloth(a), weft::Status::invalid_handle);
  EXPECT_TRUE(second.world().valid(b));
}

TEST(BadCollider, DegenerateShapesAreRefused) {
  TestWorld test;
  add_particles(test, {{0, 5, 0}});
  for (const double bad : not_positive) {
    weft::CapsuleDesc capsule;
    capsule.radius = bad;
    expect_refused_unchanged(test, {"capsule.radius"},
                             [&] { return test.world().create_capsule(capsule).status(); });
    weft::CylinderDesc cylinder;
    cylinder.radius = bad;
    expect_refused_unchanged(test, {"cylinder.radius"},
                             [&] { return test.world().create_cylinder(cylinder).status(); });
    weft::BoxDesc box;
    box.half.z = bad;
    expect_refused_unchanged(test, {"box.half.z"},
                             [&] { return test.world().create_box(box).status(); });
  }
  weft::CylinderDesc flat;
  flat.a = flat.b = {1, 2, 3};
  expect_refused_unchanged(test, {"cylinder.a", "cylinder.b"},
                           [&] { return test.world().create_cylinder(flat).status(); });
  weft::BoxDesc turned;
  turned.axis = {0, 0, 0};
  turned.degrees = 10;
  expect_refused_unchanged(test, {"box.axis"},
                           [&] { return test.world().create_box(turned).status(); });
}

TEST(BadCollider, FrictionAndVelocityOfEveryShapeAreChecked) {
  TestWorld test;
  add_particles(test, {{0, 5, 0}});
  for (const double bad : {-0.5, infinity, not_a_number}) {
    weft::CapsuleDesc capsule;
    capsule.friction = bad;
    expect_refused_unchanged(test, {"capsule.friction"},
                             [&] { return test.world().create_capsule(capsule).status(); });
    weft::BoxDesc box;
    box.friction = bad;
    expect_refused_unchanged(test, {"box.friction"},
                             [&] { return test.world().create_box(box).status(); });
    weft::SphereDesc sphere;
    sphere.friction = bad;
    expect_refused_unchanged(test, {"sphere.friction"},
                             [&] { return test.world().create_sphere(sphere).status(); });
  }
  weft::CylinderDesc cylinder;
  cylinder.velocity.y = not_a_number;
  expect_refused_unchanged(test, {"cylinder.velocity"},
                           [&] { return test.world().create_cylinder(cylinder).status(); });
}

}  // namespace
}  // namespace weft_tests
