#include "kernels/mesh_contact.h"

#include <gtest/gtest.h>

#include "reference/mesh_on_device.h"
#include "reference/mesh_shapes.h"
#include "reference/random.h"

namespace weft {
using namespace WEFT_BACKEND_NS;

namespace {

using reference::SplitMix;
using reference::Triangles;
using reference::Vec;

template <class T>
Vec3<T> narrowed(Vec v) {
  return {T(v.x), T(v.y), T(v.z)};
}
template <class T>
Vec wide(Vec3<T> v) {
  return {double(v.x), double(v.y), double(v.z)};
}

template <class T>
struct Bench {
  Triangles mesh;
  double thickness;
  reference::MeshOnDevice<T> device;

  Bench(const Triangles& triangles, double t, bool closed)
      : mesh(triangles), thickness(t), device(reference::cook(triangles, t, closed)) {}

  MeshContact<T> operator()(Vec from, Vec to) const {
    return mesh_contact(device.grid, narrowed<T>(from), narrowed<T>(to));
  }
  double distance(Vec x) const { return reference::distance_to_mesh(mesh, x); }
  /// Of a number of the size of the mesh.
  double rounding() const { return sizeof(T) == 4 ? 4e-7 : 1e-14; }

  /// At most `away` from a vertex along every axis.
  Vec near_surface(SplitMix& random, double away) const {
    const size_t v = random.bits() % mesh.vertices.size();
    return wide(narrowed<T>(mesh.vertices[v] + random.noise(away)));
  }
};

template <class T>
class MeshContactTest : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(MeshContactTest, Scalars);

struct Shape {
  Triangles mesh;
  double thickness;
  bool closed;
};
std::vector<Shape> shapes() {
  const Triangles one{{{0.1, 0.2, 0.3}, {1.1, 0.1, 0.2}, {0.4, 0.9, 0.5}}, {{0, 1, 2}}};
  return {{reference::box({0.5, 0.4, 0.3}), 0.05, true}, {reference::ball(1, 3), 0.02, true},
          {reference::ball(1, 3, 1.2), 0.2, true},       {reference::ball(1, 3, 1.2), 0.01, false},
          {reference::sheet(1, 20, 0.1), 0.05, false},   {one, 0.1, false}};
}

}  // namespace

TYPED_TEST(MeshContactTest, FindsTheNearestPointOfTheWholeMesh) {
  SplitMix random(1);
  for (const Shape& shape : shapes()) {
    const Bench<TypeParam> bench(shape.mesh, shape.thickness, shape.closed);
    for (int i = 0; i < 2000; ++i) {
      const Vec x = bench.near_surface(random, 2 * shape.thickness);
      const double distance = bench.distance(x);
      const Nearest<TypeParam> found = nearest(bench.device.grid, narrowed<TypeParam>(x));
      if (std::fabs(distance - shape.thickness) < bench.rounding()) continue;
      const bool inside = shape.closed && reference::is_inside(shape.mesh, x);
      ASSERT_EQ(found.triangle >= 0, inside || distance < shape.thickness) << distance;
      if (found.triangle < 0) continue;
      ASSERT_EQ(found.inside, inside) << distance;
      if (inside && distance > shape.thickness) continue;  // may be approximate
      ASSERT_NEAR(std::sqrt(double(found.distance2)), distance, bench.rounding());
      ASSERT_NEAR(bench.distance(x - wide(found.away)), 0, bench.rounding());
    }
  }
}

TYPED_TEST(MeshContactTest, AParticleGoesToTheThicknessOutsideOfAConvexMesh) {
  SplitMix random(2);
  for (const Triangles& mesh : {reference::box({0.5, 0.4, 0.3}), reference::ball(1, 3)}) {
    const Bench<TypeParam> bench(mesh, 0.05, true);
    for (int i = 0; i < 2000; ++i) {
      const Vec x = bench.near_surface(random, 0.1);
      const MeshContact<TypeParam> contact = bench(x, x);
      ASSERT_FALSE(contact.stopped);
      if (!contact.hit) continue;
      const Vec to = wide(contact.to);
      ASSERT_NEAR(bench.distance(to), 0.05, 0.05 * 1e-5 + bench.rounding());
      ASSERT_FALSE(reference::is_inside(mesh, to));
      ASSERT_NEAR(reference::length(wide(contact.normal)), 1, 1e-6);
      ASSERT_NEAR(bench.distance(to - 0.05 * wide(contact.normal)), 0, bench.rounding());
    }
  }
}

TYPED_TEST(MeshContactTest, DeepInsideLeadsOut) {
  SplitMix random(3);
  for (const double dent : {0.0, 1.2}) {
    const Triangles mesh = reference::ball(1, 3, dent);
    const Bench<TypeParam> bench(mesh, 0.01, true);
    for (int i = 0; i < 2000; ++i) {
      const Vec x = random.noise(1);
      if (!reference::is_inside(mesh, x) || bench.distance(x) < 1e-5) continue;
      const MeshContact<TypeParam> contact = bench(x, x);
      ASSERT_TRUE(contact.hit);
      ASSERT_FALSE(reference::is_inside(mesh, wide(contact.to)));
      ASSERT_LT(bench.distance(wide(contact.to)), 0.011);
    }
  }
}

TYPED_TEST(MeshContactTest, OnTheSurfaceTheNormalIsAFiniteUnitVector) {
  for (const Shape& shape : shapes()) {
    const Bench<TypeParam> bench(shape.mesh, shape.thickness, shape.closed);
    for (size_t f = 0; f < shape.mesh.faces.size(); f += 7) {
      const auto& [a, b, c] = shape.mesh.faces[f];
      const Vec va = shape.mesh.vertices[a], vb = shape.mesh.vertices[b],
                vc = shape.mesh.vertices[c];
      for (const Vec x : {va, vb, vc, 0.5 * (va + vb), 0.25 * (va + vb) + 0.5 * vc}) {
        const MeshContact<TypeParam> contact = bench(x, x);
        ASSERT_TRUE(contact.hit);
        ASSERT_NEAR(reference::length(wide(contact.normal)), 1, 1e-6);
        const Vec to = wide(contact.to);
        ASSERT_GT(bench.distance(to), 0.2 * shape.thickness);  // less than all of it in hollows
        ASSERT_FALSE(shape.closed && reference::is_inside(shape.mesh, to));
      }
    }
  }
}

TYPED_TEST(MeshContactTest, ATwoSidedSheetKeepsItsSides) {
  SplitMix random(4);
  const double t = 0.05;
  const Triangles mesh = reference::sheet(1, 20, 0.02);
  const Bench<TypeParam> bench(mesh, t, false);
  int crossed = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec from = bench.near_surface(random, 0.04);
    const Vec to = wide(narrowed<TypeParam>(from + random.noise(0.4 * t / 1.74)));
    if (bench.distance(from) < 1e-3) continue;
    const bool through = reference::crosses(mesh, from, to);
    const MeshContact<TypeParam> contact = bench(from, to);
    if (!contact.hit) {
      ASSERT_FALSE(through);
      continue;
    }
    const Vec out = wide(contact.to);
    ASSERT_FALSE(reference::crosses(mesh, from, out)) << bench.distance(from);
    ASSERT_GT(bench.distance(out), 0.85 * t);  // nearer than t only where the sheet is hollow
    ASSERT_LT(bench.distance(out), t * (1 + 1e-5) + bench.rounding());
    crossed += through;
  }
  EXPECT_GT(crossed, 200);
}

TYPED_TEST(MeshContactTest, AFlatSheetHoldsAtTheThickness) {
  SplitMix random(5);
  const double t = 0.01;
  const Bench<TypeParam> bench(reference::sheet(1, 30, 0), t, false);
  for (int i = 0; i < 2000; ++i) {
    Vec from = random.noise(0.4), to = from + random.noise(0.4 * t / 1.74);
    from.z = i % 2 ? 1e-3 : -1e-3;
    to.z = from.z + t * 0.3 * (random.uniform() - 0.5);
    const MeshContact<TypeParam> contact = bench(from, to);
    ASSERT_TRUE(contact.hit);
    ASSERT_NEAR(double(contact.to.z), i % 2 ? t : -t, t * 1e-5 + bench.rounding());
    ASSERT_NEAR(double(contact.to.x), to.x, bench.rounding());
  }
}

TYPED_TEST(MeshContactTest, GoingRoundTheRimOfASheetIsNoCrossing) {
  const double t = 0.05;
  const Bench<TypeParam> bench(reference::sheet(1, 10, 0), t, false);
  Vec x{0.5, 0.01, 0.9 * t};
  for (int i = 0; i < 200; ++i) {
    const double angle = 1.5707963 - 3.1415926 * i / 199;
    const Vec next{0.5 + 0.9 * t * std::cos(angle), 0.01, 0.9 * t * std::sin(angle)};
    const MeshContact<TypeParam> contact = bench(x, next);
    ASSERT_TRUE(contact.hit);
    ASSERT_LT(reference::length(wide(contact.to) - next), 0.11 * t);
    x = next;
  }
}

TYPED_TEST(MeshContactTest, NothingTunnelsAt300MetresPerSecond) {
  SplitMix random(6);
  const double t = 0.002, way = 300.0 / 600;
  const Triangles mesh = reference::sheet(1, 12, 0.1);
  const Triangles box = reference::box({0.3, 0.3, 0.001});
  const Bench<TypeParam> sheet(mesh, t, false), plate(box, t, true);
  for (int i = 0; i < 3000; ++i) {
    Vec from = random.noise(0.28), direction = random.noise(1);
    from.z += i % 2 ? 0.3 : -0.3;
    direction = (1 / reference::length(direction)) * direction;
    if (i % 3 == 0) direction = {0, 0, from.z > 0 ? -1.0 : 1.0};
    const Vec to = from + way * direction;
    for (const Bench<TypeParam>* bench : {&sheet, &plate}) {
      const MeshContact<TypeParam> contact = (*bench)(from, to);
      if (reference::crosses(bench->mesh, from, to)) {
        ASSERT_TRUE(contact.hit);
        ASSERT_TRUE(contact.stopped);
      }
      if (!contact.hit) continue;
      ASSERT_FALSE(reference::crosses(bench->mesh, from, wide(contact.to)));
      ASSERT_LT(bench->distance(wide(contact.to)), t * (1 + 1e-5) + bench->rounding());
    }
  }
}

TYPED_TEST(MeshContactTest, AFastParticleThatStartsInContactDoesNotTunnel) {
  SplitMix random(7);
  const double t = 0.002;
  const Triangles mesh = reference::ball(0.2, 3);
  const Bench<TypeParam> solid(mesh, t, true), shell(mesh, t, false);
  for (int i = 0; i < 2000; ++i) {
    Vec from = random.noise(1);
    from = ((0.2 + t * random.uniform()) / reference::length(from)) * from;
    const Vec to = from + random.noise(0.3);
    if (reference::is_inside(mesh, from) || solid.distance(from) < 1e-5) continue;
    for (const Bench<TypeParam>* bench : {&solid, &shell}) {
      const MeshContact<TypeParam> contact = (*bench)(from, to);
      const Vec end = contact.hit ? wide(contact.to) : to;
      ASSERT_FALSE(reference::is_inside(mesh, end));
      ASSERT_TRUE(contact.hit || !reference::crosses(mesh, from, to));
    }
  }
}

TYPED_TEST(MeshContactTest, FarAwayAndNotANumberAreNoContact) {
  const Bench<TypeParam> bench(reference::box({1, 1, 1}), 0.01, true);
  const double nan = std::nan(""), far = 1e9;
  for (const Vec x : {Vec{3, 0, 0}, Vec{far, -far, far}, Vec{nan, 0, 0}, Vec{nan, nan, nan}}) {
    EXPECT_FALSE(bench(x, x).hit);
    EXPECT_FALSE(bench({2, 2, 2}, x).hit);
    EXPECT_FALSE(bench(x, {2, 2, 2}).hit);
  }
}

TYPED_TEST(MeshContactTest, AKilometreOfGroundHoldsMillimetres) {
  SplitMix random(8);
  const double t = 0.005, rounding = sizeof(TypeParam) == 4 ? 2e-4 : 1e-9;
  const Bench<TypeParam> bench(reference::sheet(1000, 40, 20), t, false);
  for (int i = 0; i < 1000; ++i) {
    const auto& f = bench.mesh.faces[random.bits() % bench.mesh.faces.size()];
    const double u = random.uniform() / 2, v = random.uniform() / 2;
    const Vec a = bench.mesh.vertices[f[0]], b = bench.mesh.vertices[f[1]],
              c = bench.mesh.vertices[f[2]];
    const Vec x = a + u * (b - a) + v * (c - a) + Vec{0, 0, 0.7 * t};
    const MeshContact<TypeParam> contact = bench(x + Vec{0, 0, 10}, x);
    ASSERT_TRUE(contact.hit);
    ASSERT_NEAR(bench.distance(wide(contact.to)), t, rounding);
    ASSERT_GT(contact.normal.z, 0);
  }
}

}  // namespace weft
