// Contact without friction along curved surfaces: nothing is driven (HC49 and its like).
#include "reference/turning.h"

namespace weft_tests::curved_contact {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr Vec middle{0.3, -0.2, 0.4};

/// About `ahead` through `middle`: a closed profile of (radius, height), turned. The first and the
/// last point lie on the axis.
Triangles revolved(const std::vector<std::pair<double, double>>& profile, int around) {
  Triangles mesh;
  const auto number = [&](size_t k, int i) {
    if (k == 0) return 0u;
    return 1 + uint32_t(k - 1) * uint32_t(around) + uint32_t(i % around);
  };
  const auto at = [&](size_t k, int i) {
    const auto [r, y] = profile[k];
    const double angle = 2 * pi * i / around;
    return middle + y * ahead + r * (std::cos(angle) * across + std::sin(angle) * beside);
  };
  const size_t last = profile.size() - 1;
  mesh.vertices.push_back(at(0, 0));
  for (size_t k = 1; k < last; ++k)
    for (int i = 0; i < around; ++i) mesh.vertices.push_back(at(k, i));
  const auto top = uint32_t(mesh.vertices.size());
  mesh.vertices.push_back(at(last, 0));
  for (int i = 0; i < around; ++i) {
    mesh.faces.push_back({0, number(1, i), number(1, i + 1)});
    for (size_t k = 1; k + 1 < last; ++k) {
      const uint32_t a = number(k, i), b = number(k, i + 1);
      const uint32_t c = number(k + 1, i), d = number(k + 1, i + 1);
      mesh.faces.push_back({a, c, b});
      mesh.faces.push_back({b, c, d});
    }
    mesh.faces.push_back({number(last - 1, i), top, number(last - 1, i + 1)});
  }
  return mesh;
}

/// With caps of half balls that begin `half` away from the middle; 0 is a ball.
std::vector<std::pair<double, double>> rounded(double radius, double half) {
  std::vector<std::pair<double, double>> profile{{0, -half - radius}};
  const int parts = 16;
  for (int k = 1 - parts; k < parts; ++k) {
    const double angle = pi / 2 * k / parts;
    if (k == 0 && half > 0) profile.push_back({radius, -half});
    profile.push_back(
        {radius * std::cos(angle), (k < 0 ? -half : half) + radius * std::sin(angle)});
  }
  profile.push_back({0, half + radius});
  return profile;
}

constexpr double radius = 0.2, thickness = 0.01;

enum class Round { sphere, capsule, cylinder, ball_mesh, capsule_mesh, cylinder_mesh };
constexpr Round every_round[] = {Round::sphere,    Round::capsule,      Round::cylinder,
                                 Round::ball_mesh, Round::capsule_mesh, Round::cylinder_mesh};

/// About the axis `ahead`; meshes are so fine that their corners are 0.01 mm high.
weft::ColliderId add_round(TestWorld& test, Round shape, double friction) {
  const double half = 0.5, inner = radius - thickness;
  const int around = 320;
  weft::MeshColliderDesc mesh;
  mesh.friction = friction;
  switch (shape) {
    case Round::sphere: {
      weft::SphereDesc desc;
      desc.center = to_weft(middle);
      desc.radius = radius;
      desc.friction = friction;
      return test.take(test.world().create_sphere(desc));
    }
    case Round::capsule: {
      weft::CapsuleDesc desc;
      desc.a = to_weft(middle - half * ahead);
      desc.b = to_weft(middle + half * ahead);
      desc.radius = radius;
      desc.friction = friction;
      return test.take(test.world().create_capsule(desc));
    }
    case Round::cylinder: {
      weft::CylinderDesc desc;
      desc.a = to_weft(middle - half * ahead);
      desc.b = to_weft(middle + half * ahead);
      desc.radius = radius;
      desc.friction = friction;
      return test.take(test.world().create_cylinder(desc));
    }
    case Round::ball_mesh:
      return add_collider(test, revolved(rounded(inner, 0), 100), thickness, true, mesh);
    case Round::capsule_mesh:
      return add_collider(test, revolved(rounded(inner, half), around), thickness, true, mesh);
    case Round::cylinder_mesh:
      break;
  }
  return add_collider(test,
                      revolved({{0, -half}, {inner, -half}, {inner, half}, {0, half}}, around),
                      thickness, true, mesh);
}

constexpr int beads = 40;
constexpr double bead_mass = 1e-4, stiffness = 150, stretch = 0.12;
/// m/s^2: with which the stretched ring presses its beads onto the surface.
double pressure() {
  const double rest = 2 * radius * std::sin(pi / beads) / (1 + stretch);
  return 2 * stiffness * stretch * rest * std::sin(pi / beads) / bead_mass;
}

/// A stretched ring that turns at `speed`.
weft::ClothId add_ring(TestWorld& test, double speed) {
  std::vector<weft::double3> x, v;
  std::vector<weft::Spring> springs;
  const double rest = 2 * radius * std::sin(pi / beads) / (1 + stretch);
  for (uint32_t i = 0; i < beads; ++i) {
    const double angle = 2 * pi * (i + 0.3) / beads;
    const Vec out = std::cos(angle) * across + std::sin(angle) * beside;
    x.push_back(to_weft(middle + radius * out));
    v.push_back(to_weft(speed * cross(ahead, out)));
    springs.push_back({i, (i + 1) % beads, stiffness, rest});
  }
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.springs = springs;
  network.material.mass.value = beads * bead_mass;
  weft::ClothDesc cloth;
  cloth.velocities = weft::View<weft::double3>(v);
  return test.add(network, cloth);
}

/// Mean speed about the axis.
double turning(TestWorld& test, weft::ClothId ring) {
  const std::vector<Vec> x = test.positions(ring), v = test.velocities(ring);
  double sum = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const Vec from = x[i] - middle, out = from - dot(from, ahead) * ahead;
    sum += dot(cross(ahead, (1 / length(out)) * out), v[i]);
  }
  return sum / double(x.size());
}

weft::WorldDesc still_world(weft::Precision precision, weft::Form form) {
  weft::WorldDesc desc;
  desc.gravity = {0, 0, 0};
  desc.precision = precision;
  desc.form = form;
  return desc;
}

using CurvedContact = BothPrecisions;

TEST_P(CurvedContact, ARingThatTurnsKeepsItsSpeed) {
  for (const Round shape : every_round)
    for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
      SCOPED_TRACE(testing::Message() << "shape " << int(shape) << ", form " << int(form));
      // A ball lets a ring go that is not quite straight: it holds no longer than its rounding.
      if (shape == Round::sphere || shape == Round::ball_mesh) continue;
      TestWorld test(still_world(GetParam(), form));
      const weft::ClothId ring = add_ring(test, 1);
      add_round(test, shape, 0);
      const int seconds = shape == Round::capsule || shape == Round::cylinder ? 10 : 5;
      for (int s = 0; s < seconds; ++s) {
        test.step(1.0 / 60, 60);
        // In float the facets of a mesh, and what they shake, cost more than in double.
        const bool coarse = shape >= Round::ball_mesh && GetParam() == weft::Precision::float32;
        ASSERT_NEAR(turning(test, ring), 1, coarse ? 0.04 : 0.01) << "after " << s + 1 << " s";
      }
    }
}

/// One that a spring's other end at the middle holds down cannot leave the equator.
TEST_P(CurvedContact, ABeadOnATetherOfRubberKeepsItsSpeedOnEveryShape) {
  for (const Round shape : every_round)
    for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
      SCOPED_TRACE(testing::Message() << "shape " << int(shape) << ", form " << int(form));
      TestWorld test(still_world(GetParam(), form));
      const std::vector<weft::double3> x{to_weft(middle), to_weft(middle + radius * across)};
      const std::vector<weft::Spring> springs{{0, 1, 20, 0.05}};
      const std::vector<weft::double3> v{{0, 0, 0}, to_weft(1.5 * beside)};
      weft::NetworkDesc network;
      network.positions = weft::View<weft::double3>(x);
      network.springs = springs;
      network.material.mass.value = 0.02;
      weft::ClothDesc cloth;
      cloth.velocities = weft::View<weft::double3>(v);
      const weft::Pin pin{0};
      cloth.pins = weft::View<weft::Pin>(&pin, 1);
      const weft::ClothId bead = test.add(network, cloth);
      add_round(test, shape, 0);
      const double energy = test.mechanics().kinetic + test.mechanics().elastic;
      test.step(1.0 / 120, 600);
      const bool mesh = int(shape) >= int(Round::ball_mesh);
      // On the facets of a ball it climbs from ring to ring: its energy is what stays.
      if (shape != Round::ball_mesh) {
        EXPECT_NEAR(length(test.velocities(bead)[1]), 1.5, mesh ? 0.03 : 0.003);
      }
      EXPECT_LE(test.mechanics().kinetic + test.mechanics().elastic,
                (mesh ? 1.02 : 1.003) * energy);
      EXPECT_NEAR(length(test.position(bead, 1) - middle), radius, mesh ? 1e-3 : 1e-4);
    }
}

/// What spins about its own axis is where it was: without friction it takes nothing along and
/// brakes nothing, however far it turns in a frame.
TEST_P(CurvedContact, WhatSpinsAboutItsAxisWithoutFrictionDrivesNothing) {
  for (const Round shape : every_round)
    for (const weft::Form form : {weft::Form::summed, weft::Form::position})
      for (const double degrees : {12.0, -25.0})
        for (const double speed : {0.0, 1.0}) {
          SCOPED_TRACE(testing::Message() << "shape " << int(shape) << ", form " << int(form)
                                          << ", " << degrees << " degrees, " << speed << " m/s");
          if (shape == Round::sphere || shape == Round::ball_mesh) continue;  // lets a ring go
          TestWorld test(still_world(GetParam(), form));
          const weft::ClothId ring = add_ring(test, speed);
          const weft::ColliderId id = add_round(test, shape, 0);
          for (int n = 1; n <= 30; ++n) {
            test.check(test.world().move_collider(id, about(middle, {}, ahead, degrees * n)));
            test.step(1.0 / 60);
          }
          // The edges between facets of a mesh push a little.
          const bool facets = shape == Round::capsule_mesh || shape == Round::cylinder_mesh;
          EXPECT_NEAR(turning(test, ring), speed, facets ? 0.05 : 0.02);
        }
}

/// dv/dt = -mu (A - v^2/R): at rest after R/(mu s) atanh(v/s), s^2 = A R.
TEST_P(CurvedContact, FrictionBrakesARingAsItIsPressed) {
  const double mu = 0.02, s = std::sqrt(pressure() * radius);
  const double until_rest = radius / (mu * s) * std::atanh(1 / s);
  for (const Round shape : {Round::capsule, Round::cylinder, Round::cylinder_mesh})
    for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
      SCOPED_TRACE(testing::Message() << "shape " << int(shape) << ", form " << int(form));
      TestWorld test(still_world(GetParam(), form));
      const weft::ClothId ring = add_ring(test, 1);
      add_round(test, shape, mu);
      const double dt = until_rest / 10;
      test.step(dt, 5);
      const double left = s * std::tanh(mu * s / radius * (until_rest / 2));
      EXPECT_NEAR(turning(test, ring), left, 0.03 * left);
      test.step(dt, 10);
      EXPECT_NEAR(turning(test, ring), 0, 1e-6);
      const std::vector<Vec> rests = test.positions(ring);
      test.step(dt, 5);
      const std::vector<Vec> later = test.positions(ring);
      for (size_t i = 0; i < rests.size(); ++i) {
        EXPECT_LE(length(later[i] - rests[i]), 1e-7) << "it creeps";
      }
    }
}

/// The energy of what slides off or over a convex shape in free flight never grows, whatever edge
/// or side it meets.
TEST_P(CurvedContact, NoShapeAddsEnergyToWhatMeetsIt) {
  for (const Body body : every_body) {
    SCOPED_TRACE(name(body));
    for (int i = 0; i < 24; ++i) {
      TestWorld test(still_world(GetParam(), weft::Form::summed));
      const Vec top{0.2, 0.1, -0.3}, centre = top - Vec{0, 0.2, 0};
      const Vec side = turned(ahead, Vec{1, 2, 3}, 37 * i), aim = turned(across, ahead, 29 * i);
      const double speed = 2 + 0.4 * i;
      const Vec way = (1 / length(aim - 0.7 * side)) * (aim - 0.7 * side);
      const Vec from = centre + 0.45 * side + (body == Body::plane ? Vec{0, 0.5, 0} : Vec{});
      const weft::ClothId cloth = add_particles(test, {from}, speed * way);
      add_body(test, body, top, 0.2);
      for (int k = 0; k < 60; ++k) {
        test.step(1.0 / 240);
        ASSERT_LE(length(test.velocities(cloth)[0]), speed * (1 + 1e-4)) << i << " " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, CurvedContact, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::curved_contact
