// A back end whose memory the host cannot read, as a GPU's: outputs take the way over copies. Here
// it is the host's own, in the layout that a GPU may have, and says that it is far.
#include <gtest/gtest.h>

#include <cstring>

#include "api/context/context_state.h"
#include "api/context/registry.h"
#include "api/world/state.h"
#include "backends.h"

namespace weft::testing {
namespace {

class FarBackend final : public Backend {
 public:
  explicit FarBackend(const Backend& near) : near_(near), info_(near.info()) {
    info_.host_memory = false;
  }
  const BackendInfo& info() const noexcept override { return info_; }
  void* allocate(const Allocator& host, size_t bytes) const noexcept override {
    return near_.allocate(host, bytes);
  }
  void release(const Allocator& host, void* memory, size_t bytes) const noexcept override {
    near_.release(host, memory, bytes);
  }
  Status zero(void* p, size_t n) const noexcept override { return near_.zero(p, n); }
  Status to_device(void* to, const void* from, size_t n) const noexcept override {
    return near_.to_device(to, from, n);
  }
  Status to_host(void* to, const void* from, size_t n) const noexcept override {
    return near_.to_host(to, from, n);
  }
  Status frame(Frame<float>& f) const noexcept override { return near_.frame(f); }
  Status frame(Frame<double>& f) const noexcept override { return near_.frame(f); }
  Status start(Frame<float>& f) const noexcept override { return near_.start(f); }
  Status start(Frame<double>& f) const noexcept override { return near_.start(f); }
  Status accelerations(const Frame<float>& f) const noexcept override {
    return near_.accelerations(f);
  }
  Status accelerations(const Frame<double>& f) const noexcept override {
    return near_.accelerations(f);
  }
  Status probe(const Frame<float>& f, Vec3Array<float> x,
               Vec3Array<float> d) const noexcept override {
    return near_.probe(f, x, d);
  }
  Status probe(const Frame<double>& f, Vec3Array<double> x,
               Vec3Array<double> d) const noexcept override {
    return near_.probe(f, x, d);
  }
  Status survey(const Frame<float>& f) const noexcept override { return near_.survey(f); }
  Status survey(const Frame<double>& f) const noexcept override { return near_.survey(f); }
  Status normals(const Frame<float>& f) const noexcept override { return near_.normals(f); }
  Status normals(const Frame<double>& f) const noexcept override { return near_.normals(f); }
  Status pairs(const Frame<float>& f) const noexcept override { return near_.pairs(f); }
  Status pairs(const Frame<double>& f) const noexcept override { return near_.pairs(f); }
  // The caller's buffer is not the device's: the world must ask the host's back end.
  Status write_vertices(const VertexJob<float>&, Workers) const noexcept override {
    return Status::device_lost;
  }
  Status write_vertices(const VertexJob<double>&, Workers) const noexcept override {
    return Status::device_lost;
  }
  Status shift(const OriginJob<float>& j, Workers w) const noexcept override {
    return near_.shift(j, w);
  }
  Status shift(const OriginJob<double>& j, Workers w) const noexcept override {
    return near_.shift(j, w);
  }
  Status copy(void* to, const void* from, size_t n) const noexcept override {
    return near_.copy(to, from, n);
  }
  Status sum(const float* x, int n, float* scratch, Workers w, float& out) const noexcept override {
    return near_.sum(x, n, scratch, w, out);
  }
  Status sum(const double* x, int n, double* scratch, Workers w,
             double& out) const noexcept override {
    return near_.sum(x, n, scratch, w, out);
  }
  Status exclusive_scan(const uint32_t* in, uint32_t* out, int n,
                        Workers w) const noexcept override {
    return near_.exclusive_scan(in, out, n, w);
  }
  Status stable_sort_by_key(uint32_t* keys, uint32_t* values, int n,
                            Workers w) const noexcept override {
    return near_.stable_sort_by_key(keys, values, n, w);
  }

 private:
  const Backend& near_;
  BackendInfo info_;
};

const Backend& host() { return *api::choose_backend(BackendKind::omp, Isa::automatic).backend; }

constexpr uint32_t vertices = 23 * 31;

/// What a world of a grid or a mesh writes, at several alphas, and its hash.
std::vector<char> written(const Backend& backend, Precision precision, bool as_mesh) {
  auto state = std::make_shared<api::ContextState>(ContextDesc{});
  state->backend = &backend;
  state->host_backend = &host();
  state->threads = 1;
  Context context(new Context::Impl{state});
  WorldDesc desc;
  desc.precision = precision;
  desc.interpolate = true;
  World world = std::move(*context.create_world(desc));
  ClothDesc cloth;
  const Pin pins[] = {{0}, {30}};
  cloth.pins = {pins, 2};
  cloth.pose.translate = {100.5, 2, 3};
  GridDesc grid;
  grid.rows = 23;
  grid.columns = 31;
  Fabric fabric = *context.cook(grid);
  if (as_mesh) {
    std::vector<double3> x;
    for (uint32_t v = 0; v < vertices; ++v) x.push_back({v % 31 / 30.0, v / 31 / 22.0, 0});
    std::vector<uint32_t> triangles(3 * fabric.triangle_count());
    EXPECT_EQ(fabric.read_triangles(0, fabric.triangle_count(), triangles.data()), Status::ok);
    MeshDesc mesh;
    mesh.positions = View<double3>(x);
    mesh.indices = triangles;
    fabric = *context.cook(mesh);
  }
  cloth.fabric = fabric;
  const ClothId id = *world.create_cloth(cloth);
  std::vector<char> out(vertices * 40);
  OutputDesc output;
  output.layout.position = {Format::f32x3, 0, 40};
  output.layout.normal = {Format::f32x3, 12, 40};
  output.layout.last_position = {Format::f32x4, 24, 40};
  output.origin = {100, 0, 0};
  output.memory = out.data();
  EXPECT_TRUE(world.bind_output(id, output));
  std::vector<char> all;
  for (const double alpha : {1.0, 0.3, 0.0}) {
    EXPECT_EQ(world.step(1.0 / 60), Status::ok);
    EXPECT_EQ(world.write_outputs(alpha), Status::ok);
    all.insert(all.end(), out.begin(), out.end());
    if (alpha < 1) {
      EXPECT_TRUE(world.create_sphere({}));  // the device memory is made anew
    }
  }
  const uint64_t hash = *world.state_hash();
  all.resize(all.size() + sizeof hash);
  std::memcpy(all.data() + all.size() - sizeof hash, &hash, sizeof hash);
  return all;
}

class FarMemory : public ::testing::TestWithParam<std::tuple<Precision, bool>> {};

TEST_P(FarMemory, OutputsAreTheSame) {
  const auto [precision, as_mesh] = GetParam();
  const std::vector<char> expected = written(host(), precision, as_mesh);
  for (const NamedBackend& b : backends()) {
    SCOPED_TRACE(b.name);
    if (b.backend->info().host_memory) {
      const FarBackend far(*b.backend);
      EXPECT_EQ(written(far, precision, as_mesh), expected);
    } else {
      EXPECT_EQ(written(*b.backend, precision, as_mesh), expected);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(All, FarMemory,
                         ::testing::Combine(::testing::Values(Precision::float32,
                                                              Precision::float64),
                                            ::testing::Bool()));

}  // namespace
}  // namespace weft::testing
