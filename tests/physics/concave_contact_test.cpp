// Meshes that are not convex, without friction: a push along the normal where the substep began
// must not drive what slides into a hollow.
#include "reference/effects.h"

namespace weft_tests::concave_contact {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A pipe about z, open at both ends.
Triangles pipe(double radius, double half, int around, bool inwards) {
  Triangles mesh;
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * pi * i / around;
    for (const double z : {-half, half})
      mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  for (int i = 0; i < around; ++i) {
    const auto a = uint32_t(2 * i), b = uint32_t(2 * ((i + 1) % around));
    mesh.faces.push_back({a, a + 1, b});
    mesh.faces.push_back({b, a + 1, b + 1});
  }
  if (!inwards) return mesh;
  for (auto& f : mesh.faces) std::swap(f[1], f[2]);
  return mesh;
}

using ConcaveContact = BothPrecisions;

TEST_P(ConcaveContact, APipeDrivesNothingThatSlidesRoundInIt) {
  const double radius = 0.3, thickness = 0.02;
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const bool inwards : {false, true})
      for (const int around : {7, 24, 120})
        for (const double steep : {0.0, 0.4, 1.2})
          for (const double speed : {0.2, 1.0, 4.0, 20.0}) {
            SCOPED_TRACE(testing::Message() << "form " << int(form) << ", " << around << " faces, "
                                            << steep << " rad, " << speed << " m/s");
            weft::WorldDesc desc = plain_world(GetParam());
            desc.form = form;
            TestWorld test(desc);
            const double inner = radius * std::cos(pi / around) - thickness;
            const Vec way{std::sin(steep), std::cos(steep), 0.05};
            const weft::ClothId cloth =
                add_particles(test, {{0.97 * inner, 0, -0.5}}, (speed / length(way)) * way);
            add_collider(test, pipe(radius, 5, around, inwards), thickness, false);
            for (int n = 0; n < 240; ++n) {
              const Vec before = test.position(cloth, 0);
              test.step(1.0 / 480);
              const Vec x = test.position(cloth, 0);
              ASSERT_LE(length(x - before) * 480, speed * (1 + 2e-3)) << n;
              ASSERT_LE(std::hypot(x.x, x.y), radius) << n;
            }
          }
}

INSTANTIATE_TEST_SUITE_P(Precision, ConcaveContact, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::concave_contact
