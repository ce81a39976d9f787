// A particle's memory of the triangles near it must never change a bit of what it meets.
#include <cstring>

#include <gtest/gtest.h>

#include "kernels/mesh_contact.h"
#include "reference/mesh_on_device.h"
#include "reference/mesh_shapes.h"
#include "reference/random.h"

namespace weft {
using namespace WEFT_BACKEND_NS;

namespace {

using reference::SplitMix;
using reference::Vec;

template <class T>
class MeshMemory : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(MeshMemory, Scalars);

template <class T>
bool same_bits(Vec3<T> a, Vec3<T> b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

struct Walk {
  int contacts = 0, remembered = 0;
};

/// Slides about on the surface by `stride`, pushed in a little again and again.
template <class T>
Walk walk(const reference::Triangles& mesh, double thickness, bool closed, double stride) {
  reference::MeshOnDevice<T> device(reference::cook(mesh, thickness, closed));
  SplitMix random(17);
  NearMemory<T> memory{};
  Vec3<T> x{};
  Walk done;
  for (int n = 0; n < 20000; ++n) {
    if (n % 100 == 0) {
      const Vec v = mesh.vertices[random.bits() % mesh.vertices.size()];
      const Vec p = v + random.noise(1.5 * thickness);
      x = {T(p.x), T(p.y), T(p.z)};
    }
    const Vec by = random.noise(n % 3 == 0 ? stride : stride / 50);
    const Vec3<T> to = x + Vec3<T>{T(by.x), T(by.y), T(by.z)};
    const NearMemory<T> before = memory;
    const MeshContact<T> with = mesh_contact(device.grid, x, to, memory, 1);
    const MeshContact<T> without = mesh_contact(device.grid, x, to);
    done.remembered += std::memcmp(&before, &memory, sizeof memory) == 0 ? 1 : 0;
    EXPECT_EQ(with.hit, without.hit);
    EXPECT_EQ(with.stopped, without.stopped);
    EXPECT_TRUE(same_bits(with.to, without.to));
    EXPECT_TRUE(same_bits(with.normal, without.normal));
    if (testing::Test::HasFailure()) return done;
    done.contacts += with.hit ? 1 : 0;
    x = with.hit ? with.to : to;
  }
  return done;
}

TYPED_TEST(MeshMemory, NeverChangesABit) {
  for (const bool closed : {true, false}) {
    for (const double stride : {1e-4, 3e-3, 0.02}) {
      SCOPED_TRACE(testing::Message() << closed << " " << stride);
      const Walk done = walk<TypeParam>(reference::ball(0.4, 3, 0.1), 0.02, closed, stride);
      EXPECT_GT(done.contacts, 300);
      EXPECT_GT(done.remembered, 300);
    }
  }
}

TYPED_TEST(MeshMemory, OfAnotherMeshIsNotUsed) {
  reference::MeshOnDevice<TypeParam> ball(reference::cook(reference::ball(0.4, 2), 0.02, true));
  reference::MeshOnDevice<TypeParam> box(
      reference::cook(reference::box({0.4, 0.4, 0.4}), 0.02, true));
  NearMemory<TypeParam> memory{};
  using V = Vec3<TypeParam>;
  const V from{TypeParam(0.1), TypeParam(0.02), TypeParam(0.415)};
  const V to{TypeParam(0.1), TypeParam(0.02), TypeParam(0.411)};
  for (int turn = 0; turn < 3; ++turn) {
    const auto a = mesh_contact(ball.grid, from, to, memory, 1);
    const auto b = mesh_contact(box.grid, from, to, memory, 2);
    EXPECT_TRUE(same_bits(a.to, mesh_contact(ball.grid, from, to).to));
    EXPECT_TRUE(same_bits(b.to, mesh_contact(box.grid, from, to).to));
  }
}

}  // namespace
}  // namespace weft
