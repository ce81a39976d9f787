#include "bench/effects.h"

#include <cstring>
#include <memory>

#include "bench/capes.h"
#include "bench/interleave.h"
#include "bench/sheets.h"
#include "samples/effects/effects.h"

namespace weft::bench {

namespace {

using samples::Change;
using samples::Changes;

constexpr uint32_t n = 256;

/// Along the sheet where nothing stops it: falling across it, rounding would not stir it, and what
/// damping leaves of its motion would be denormal numbers, which take twice the time.
constexpr double3 free_fall{0, -9.81, 0};

SteppedWorld::Options options_of(const Changes& changes, bool hangs) {
  SteppedWorld::Options o;
  o.begin = [changes, hangs](WorldDesc& d) {
    d.gravity = hangs ? samples::down : free_fall;
    samples::begin(changes, d);
  };
  o.dress = [changes](ClothDesc& d) { samples::dress(changes, d); };
  o.furnish = [changes](Context& context, World& world, ClothId cloth) {
    samples::Stage stage{context, world, {cloth}, {}, true};
    samples::furnish(changes, stage);
    if (!stage.colliders.empty()) samples::check(world.set_gravity(samples::down));
  };
  return o;
}

Row figure(const std::string& name, const char* metric, const char* unit, double value) {
  return {"effects", name, metric, unit, value, value, value, 1};
}

/// Of the pass of a substep, as the plan counts it.
double flops_of(World& world) {
  const auto plan = world.plan();
  for (uint32_t i = 0; plan && i < plan->passes.count; ++i) {
    if (std::strcmp(plan->passes[i].stage, "advance") == 0) {
      return plan->passes[i].flops_per_particle;
    }
  }
  return 0;
}

struct Measured {
  std::string name;
  std::shared_ptr<SteppedWorld> world;
  size_t index;
  size_t bare;  ///< of the sheet without the effect, among all that are measured
};

/// The bare sheet, and every line of the table beside the sheet that it is compared with.
class Sheets {
 public:
  explicit Sheets(Interleaved& runs) : runs_(runs) {
    add("bare sheet", {}, 0);
    for (const samples::Effect& e : samples::effects) {
      const size_t bare = e.needs.line ? add(e.needs.line, {&e.needs}, 0, true) : 0;
      add(e, e.used, bare);
      for (const Change& c : e.null) add(e, c, bare);
      for (const Change& c : e.timed) add(e, c, bare);
    }
  }
  const std::vector<Measured>& all() const { return all_; }

 private:
  void add(const samples::Effect& e, const Change& c, size_t bare) {
    if (c.line) add(c.line, {&e.needs, &c}, bare, e.needs.line != nullptr);
  }
  /// `hangs`: from pins.
  size_t add(const std::string& name, const Changes& changes, size_t bare, bool hangs = false) {
    auto world = std::make_shared<SteppedWorld>(
        SteppedWorld::sheet(n, Stencil::seed12, options_of(changes, hangs)));
    for (int call = 0; call < 4; ++call) world->advance();
    const size_t index = runs_.add({name, world->particle_steps(), [world] { world->advance(); }});
    all_.push_back({name, world, index, bare});
    return all_.size() - 1;
  }

  Interleaved& runs_;
  std::vector<Measured> all_;
};

struct Size {
  double bytes, flops, passes;
};
Size size_of(const Measured& m) {
  World& world = m.world->world();
  return {double(world.stats().bytes_state) / m.world->particles(), flops_of(world),
          double((*world.plan()).passes.count)};
}

/// What `m` adds to the sheet that it is compared with.
void append_price(const Interleaved& runs, const Measured& m, const Measured& bare,
                  std::vector<Row>& rows) {
  const Size more = size_of(m), less = size_of(bare);
  runs.append_difference(m.name, "ns", m.index, bare.index, rows);
  runs.append_ratio(m.name, m.index, bare.index, rows);
  rows.push_back(figure(m.name, "bytes_added", "B/particle", more.bytes - less.bytes));
  rows.push_back(figure(m.name, "flops_added", "1/particle", more.flops - less.flops));
  rows.push_back(figure(m.name, "passes_added", "1", more.passes - less.passes));
}

void append_normals(int rounds, std::ostream& progress, const Measured& bare,
                    std::vector<Row>& rows) {
  Interleaved runs("effects");
  auto out = std::make_shared<std::vector<float3>>(n * n);
  auto world = bare.world;
  runs.add({"normals, one call with the copy to the caller", world->particles(), [world, out] {
              world->advance();
              (void)world->world().read_normals(world->cloth(), out->data());
            }});
  runs.add({"a call without normals", world->particles(), [world] { world->advance(); }});
  runs.run(rounds, progress);
  runs.append_difference("normals, one call with the copy to the caller", "ns/particle", 0, 1,
                         rows);
}

}  // namespace

std::vector<Row> run_effects(bool quick, std::ostream& progress) {
  const int rounds = quick ? 9 : 31;
  std::vector<Row> rows;
  Interleaved runs("effects");
  const Sheets sheets(runs);
  const std::vector<Measured>& all = sheets.all();
  runs.run(rounds, progress);
  runs.append_times("ns_per_particle_step", "ns", rows);
  const Size size = size_of(all[0]);
  rows.push_back(figure(all[0].name, "flops", "1/particle", size.flops));
  rows.push_back(figure(all[0].name, "bytes", "B/particle", size.bytes));
  rows.push_back(figure(all[0].name, "passes", "1", size.passes));
  for (size_t i = 1; i < all.size(); ++i) append_price(runs, all[i], all[all[i].bare], rows);
  append_capes(rounds, progress, rows);
  append_normals(rounds, progress, all[0], rows);
  return rows;
}

}  // namespace weft::bench
