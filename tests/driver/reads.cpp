// What a world tells of itself.
#include "run.h"

#include "weft/debug_draw.hpp"

#include <algorithm>
#include <tuple>

namespace weft_tests::driver {

using weft::Status;

namespace {

/// Points of a world with a stride; what lies between and behind them must stay.
template <class Point>
class Buffer {
 public:
  Buffer(Random& r, uint32_t points)
      : stride_(r.chance(0.7) ? sizeof(Point)
                              : static_cast<uint32_t>(sizeof(Point) + 8 * r.from_to(1, 3))),
        bytes_(size_t(points) * stride_ + 16, 0xa5) {}
  Point* data() { return reinterpret_cast<Point*>(bytes_.data()); }
  uint32_t stride() const { return stride_; }
  void check(bool written) const {
    for (size_t i = 0; i < bytes_.size(); ++i) {
      const bool is_gap = i + 16 >= bytes_.size() || i % stride_ >= sizeof(Point);
      if ((is_gap || !written) && bytes_[i] != 0xa5) {
        throw Finding(printed("byte %zu of a buffer of points was written", i));
      }
    }
  }
  uint64_t digest() const {
    Digest d;
    d.add(bytes_.data(), bytes_.size());
    return d.value();
  }

 private:
  uint32_t stride_;
  std::vector<unsigned char> bytes_;
};

template <class Point, class Read>
Outcome read_into(Random& r, const ModelCloth* cloth, const Read& read) {
  Buffer<Point> buffer(r, cloth ? cloth->vertices : 3);
  Expect expect = cloth ? Expect::ok : Expect::handle;
  uint32_t stride = buffer.stride();
  Point* to = buffer.data();
  if (cloth && cloth->vertices > 0 && r.chance(0.2)) {
    expect = Expect::refusal;
    if (r.chance(0.5)) {
      to = nullptr;
    } else {
      stride = r.below(sizeof(Point));
    }
  }
  const Status status = read(to, stride);
  buffer.check(status == Status::ok);
  return {status, expect, buffer.digest()};
}

}  // namespace

Outcome Run::read_points(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const ModelCloth* cloth = pick_cloth(r, w, id);
  const bool normals = r.chance(0.4);
  const auto read = [&](auto* to, uint32_t stride) {
    return normals ? w.world.read_normals(id, to, stride) : w.world.read_positions(id, to, stride);
  };
  return r.chance(0.5) ? read_into<weft::double3>(r, cloth, read)
                       : read_into<weft::float3>(r, cloth, read);
}

Outcome Run::read_vectors(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const ModelCloth* cloth = pick_cloth(r, w, id);
  const bool is_null = cloth && r.chance(0.15);
  std::vector<weft::double3> out((cloth ? cloth->vertices : 3) + 1, {7, 7, 7});
  weft::double3* const to = is_null ? nullptr : out.data();
  const bool velocities = r.chance(0.5);
  const Status status =
      velocities ? w.world.read_velocities(id, to) : w.world.read_accelerations(id, to);
  require(out.back().x == 7 && (status == Status::ok || out.front().x == 7),
          "written behind the last vertex, or in a failing call");
  Digest digest;
  if (all_have_moved(w)) digest.add(out.data(), out.size() * sizeof out[0]);
  const Expect good = w.desc.accumulate == weft::Accumulate::fixed64 ? Expect::any : Expect::ok;
  return {status, is_null ? Expect::refusal : cloth ? good : Expect::handle, digest.value()};
}

Outcome Run::read_sums(Random& r, ModelWorld& w) {
  Digest digest;
  const Expect good = w.desc.accumulate == weft::Accumulate::fixed64 ? Expect::any : Expect::ok;
  if (r.chance(0.4)) {
    const weft::Result<weft::Mechanics> m = w.world.mechanics();
    if (!m) return {m.status(), good, 0};
    require(w.lost || is_extreme_ ||
                (std::isfinite(m->kinetic + m->elastic + m->potential) && m->kinetic >= 0 &&
                 m->elastic >= 0 && m->stretch >= 0),
            "energies %g, %g, %g J, stretch %g", m->kinetic, m->elastic, m->potential, m->stretch);
    for (const double value : {m->elastic, m->potential, m->stretch}) digest.add(value);
    if (all_have_moved(w)) digest.add(m->kinetic);
    return {Status::ok, good, digest.value()};
  }
  if (r.chance(0.5)) {
    const weft::Result<weft::PlanInfo> plan = w.world.plan();
    if (!plan) return {plan.status(), Expect::ok, 0};
    for (uint32_t i = 0; i < plan->passes.count; ++i) {
      require(plan->passes[i].stage && plan->passes[i].per && plan->passes[i].kernel,
              "a pass without a name");
      digest.add(plan->passes[i].count);
    }
    require(plan->evaluations.count == w.cloths.size(), "evaluations of %u of %zu cloths",
            plan->evaluations.count, w.cloths.size());
    return {Status::ok, Expect::ok, digest.value()};
  }
  if (r.chance(0.5) && !w.in_flight) {  // it has no status to tell of a refusal
    home_of(w).heap.left = Heap::endless;
    const weft::Stability s = w.world.stability();
    digest.add(s.dt_bound);
    require(s.dt_bound > 0, "a bound of %g s", s.dt_bound);
    return {Status::ok, Expect::ok, digest.value()};
  }
  weft::ClothId id;
  const bool is_there = pick_cloth(r, w, id);
  const weft::Result<weft::Stability> s = w.world.stability(id);
  if (s) {
    require(s->dt_bound > 0 && s->cloth == id, "a bound of %g s", s->dt_bound);
    digest.add(s->dt_bound);
    digest.add(s->a);
    digest.add(s->b);
  }
  return {s.status(), is_there ? Expect::ok : Expect::handle, digest.value()};
}

Outcome Run::read_pairs(Random& r, ModelWorld& w) {
  const Expect good = is_extreme_ ? Expect::any : Expect::ok;
  Digest digest;
  if (r.chance(0.4)) {
    const weft::Result<weft::ContactCounts> counts = w.world.contacts();
    if (!counts) return {counts.status(), good, 0};
    require(w.collides || counts->touching + counts->excluded + counts->listed == 0,
            "%llu pairs touch without self-collision",
            static_cast<unsigned long long>(counts->touching));
    digest.add(counts->touching);
    digest.add(counts->excluded);
    return {Status::ok, good, digest.value()};
  }
  const bool with_excluded = r.chance(0.5);
  const weft::Result<weft::View<weft::NearPair>> pairs = w.world.near_pairs(with_excluded);
  if (!pairs) return {pairs.status(), w.collides ? good : Expect::refusal, 0};
  require(w.collides, "pairs of a world that searches none");
  const uint32_t count = pairs->count;
  weft::NearPair before{};
  for (uint32_t i = 0; i < count; ++i) {
    const weft::NearPair& p = (*pairs)[i];
    const auto place = [&](weft::ClothId id) {
      size_t at = 0;
      while (at < w.cloths.size() && w.cloths[at].id != id) ++at;
      require(at < w.cloths.size(), "a pair of a cloth that is not there");
      return at;
    };
    const size_t a = place(p.cloth_a), b = place(p.cloth_b);
    require(p.vertex_a < w.cloths[a].vertices && p.vertex_b < w.cloths[b].vertices,
            "a pair of vertices that are not there");
    require(a < b || (a == b && p.vertex_a < p.vertex_b), "a pair the other way round");
    if (i > 0) {
      const size_t last_a = place(before.cloth_a), last_b = place(before.cloth_b);
      const bool ascends = std::tie(last_a, before.vertex_a, last_b, before.vertex_b) <
                           std::tie(a, p.vertex_a, b, p.vertex_b);
      require(ascends, "pairs that do not ascend");
    }
    before = p;
    digest.add(a);
    digest.add(b);
    digest.add(p.vertex_a);
    digest.add(p.vertex_b);
  }
  const weft::Result<weft::ContactCounts> counts = w.world.contacts();
  if (!counts) return {counts.status(), good, 0};
  require(with_excluded ? counts->touching <= count : counts->touching == count,
          "%llu pairs touch of %u found", static_cast<unsigned long long>(counts->touching), count);
  return {Status::ok, good, digest.value()};
}

Outcome Run::ask_any_time(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const ModelCloth* cloth = pick_cloth(r, w, id);
  require(w.world.valid(id) == (cloth != nullptr), "valid is wrong");
  const weft::Stats stats = w.world.stats();
  require(stats.bytes_total > 0 && stats.phases.count >= 3, "stats without memory or phases");
  require(stats.substeps_last <= stats.substeps_most && stats.dt_least <= stats.dt_last,
          "the last substeps are beyond the most");
  require(w.in_flight || w.world.step_done(), "no step is in flight, and it is not done");
  require(home_of(w).context.bytes_allocated() > 0, "no bytes of a world that is there");
  const weft::Result<weft::Bounds> bounds = w.world.bounds(id);
  return {bounds.status(), cloth ? Expect::ok : Expect::handle, 0};
}

Outcome Run::ask_about_cloth(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const bool is_there = pick_cloth(r, w, id);
  const Expect expect = is_there ? Expect::ok : Expect::handle;
  if (r.chance(0.5)) {
    const weft::Result<bool> asleep = w.world.asleep(id);
    return {asleep.status(), expect, asleep && *asleep ? 1u : 0u};
  }
  const weft::Result<weft::View<weft::Diagnostic>> told = w.world.diagnostics(id);
  Digest digest;
  for (uint32_t i = 0; told && i < told->count; ++i) {
    require((*told)[i].text && (*told)[i].text[0], "a diagnostic without a text");
    digest.add((*told)[i].element);
  }
  return {told.status(), expect, digest.value()};
}

Outcome Run::debug_draw(Random& r, ModelWorld& w) {
  struct Drawn {
    Digest digest;
    ModelWorld* world;
    Heap* heap;
    bool calls, is_finite = true;
  } drawn{{}, &w, &home_of(w).heap, r.chance(0.3)};
  weft::DebugDraw draw;
  draw.user = &drawn;
  draw.line = [](void* user, weft::double3 a, weft::double3 b, uint32_t rgba) {
    auto& sum = *static_cast<Drawn*>(user);
    sum.is_finite &= std::isfinite(a.x + a.y + a.z + b.x + b.y + b.z);
    sum.digest.add(a);
    sum.digest.add(b);
    sum.digest.add(rgba);
    if (!sum.calls) return;
    sum.calls = false;  // the world has let go
    sum.heap->left = Heap::endless;
    (void)sum.world->world.clear_wind();
  };
  draw.what = r.chance(0.5) ? weft::DebugDraw::all : r.below(32);
  draw.full_strain = r.real(0.01, 1);
  Expect expect = Expect::ok;
  if (r.chance(0.2)) {
    expect = Expect::refusal;
    if (r.chance(0.5)) {
      draw.line = nullptr;
    } else {
      draw.full_strain = r.chance(0.5) ? 0 : r.bad();
    }
  }
  const Status status = w.world.debug_draw(draw);
  require(drawn.is_finite, "a line that is not finite");
  return {status, expect, status == Status::ok ? drawn.digest.value() : 0};
}

}  // namespace weft_tests::driver
