// Every effect on every back end and memory layout: the same bits (HC76).
#include <gtest/gtest.h>

#include <cstring>

#include "api/context/context_state.h"
#include "api/world/state.h"
#include "backends.h"
#include "reference/effect_world.h"

namespace weft::testing {
namespace {

using samples::Stage;
using weft_tests::Effect;
using weft_tests::EffectWorld;

Context context_on(const Backend& backend, uint32_t threads) {
  auto state = std::make_shared<api::ContextState>(ContextDesc{});
  state->backend = &backend;
  state->threads = threads;
  return Context(new Context::Impl{state});
}

struct Case {
  Effect effect;
  int frames = 12;
};

void dampen(ClothDesc& cloth) {
  samples::push(cloth);
  cloth.drag = 1e-4;
  cloth.spring_damping = 1e-3;
}
/// A vertex with more springs than fit into a slice, and into a chunk.
void add_hub(Stage& s) {
  reference::SplitMix random(8);
  std::vector<double3> positions{{0.5, 0.5, 0.5}};
  std::vector<Spring> springs;
  for (uint32_t i = 1; i < 1500; ++i) {
    const reference::Vec p = random.noise(0.5) + reference::Vec{0.5, 0.5, 0.6};
    positions.push_back({p.x, p.y, p.z});
    springs.push_back({0, i, 0.5, -1});
    if (i > 200) springs.push_back({7, i, 0.5 + 0.1 * (i % 3), -1});
  }
  NetworkDesc network;
  network.positions = View<double3>(positions);
  network.springs = springs;
  ClothDesc cloth;
  dampen(cloth);
  cloth.fabric = samples::take(s.context.cook(network));
  s.cloths.push_back(samples::take(s.world.create_cloth(cloth)));
}
/// All that adds to the forces of a cloth, at once.
void force(Stage& s) {
  add_hub(s);
  samples::check(s.world.set_wind({{3, 8, -2}, 1.2, 1, 0.3}));
}
Case forced(const char* name, void (*begin)(WorldDesc&)) {
  return {{.name = name, .used = {.begin = begin, .dress = dampen, .furnish = force}}, 4};
}

void tire(ClothDesc& cloth) {
  dampen(cloth);
  cloth.drag = 0.05;
  cloth.sleep_speed = 0.2;
  cloth.sleep_time = 0.05;
}
Case sleepy(const char* name, void (*begin)(WorldDesc&)) {
  return {{.name = name,
           .used = {.begin = begin,
                    .dress = tire,
                    .furnish = samples::put_all_shapes<samples::Way::rough>,
                    .lead = samples::wake_the_first}},
          12};
}

void scatter(WorldDesc& desc) { samples::scatter<Accumulate::native>(desc); }
void scatter_atomic(WorldDesc& desc) {
  samples::scatter<Accumulate::atomic>(desc);
  desc.deterministic = false;
}
const Case hubs = forced("hubs", nullptr), hubs_scattered = forced("hubs_scatter", scatter);

/// The rows of the table, and several effects at once.
const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> found;
    for (const Effect& effect : samples::effects) found.push_back({effect});
    for (const Case& c :
         {hubs, hubs_scattered, sleepy("sleep_on_shapes", nullptr),
          sleepy("sleep_on_shapes_scatter", scatter),
          forced("hubs_scatter_fixed64", samples::scatter<Accumulate::fixed64>),
          forced("hubs_scatter_float16", samples::scatter<Accumulate::float16>),
          forced("hubs_scatter_float24", samples::scatter<Accumulate::float24>),
          forced("hubs_scatter_float24_all", samples::scatter<Accumulate::float24_all>),
          forced("hubs_scatter_fixed8", samples::scatter<Accumulate::fixed8>)}) {
      found.push_back(c);
    }
    return found;
  }();
  return all;
}

/// All that a caller can read after the frames of an effect.
struct Outcome {
  std::vector<uint64_t> hashes;
  std::vector<double3> vectors;  // normals, velocities, accelerations

  bool operator==(const Outcome& o) const {
    return hashes == o.hashes && vectors.size() == o.vectors.size() &&
           std::memcmp(vectors.data(), o.vectors.data(), vectors.size() * sizeof(double3)) == 0;
  }
};

std::vector<double3> vectors_of(EffectWorld& made) {
  using Read = Status (*)(World&, ClothId, double3*);
  const Read reads[] = {
      [](World& w, ClothId c, double3* to) { return w.read_normals(c, to); },
      [](World& w, ClothId c, double3* to) { return w.read_velocities(c, to); },
      [](World& w, ClothId c, double3* to) { return w.read_accelerations(c, to); }};
  std::vector<double3> all, values(33 * 47);
  for (const Read read : reads) {
    for (const ClothId id : made.cloths()) {
      values.assign(values.size(), {0, 0, 0});
      samples::check(read(made.world(), id, values.data()));
      all.insert(all.end(), values.begin(), values.end());
    }
  }
  return all;
}

Outcome outcome(const Case& c, const Backend& backend, Precision precision, Form form,
                uint32_t threads) {
  Context context = context_on(backend, threads);
  WorldDesc desc;
  desc.precision = precision;
  desc.form = form;
  desc.evaluation = Evaluation::gather;
  EffectWorld made(context, desc, {&c.effect.needs, &c.effect.used});
  Outcome out;
  for (int frame = 4; frame <= c.frames; frame += 4) {
    made.step(4);
    out.hashes.push_back(made.hash());
    for (const ClothId id : made.cloths()) {
      out.hashes.push_back(samples::take(made.world().asleep(id)));
    }
  }
  out.vectors = vectors_of(made);
  return out;
}

class Effects : public ::testing::TestWithParam<size_t> {};

/// Each back end takes one thread and three in turn, so that both come with each precision and
/// with each form.
TEST_P(Effects, HaveTheSameBitsOnEveryBackend) {
  const Case& c = cases()[GetParam()];
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Form form : {Form::summed, Form::position}) {
      const Outcome expected = outcome(c, *backends()[0].backend, precision, form, 1);
      for (size_t b = 0; b < backends().size(); ++b) {
        const NamedBackend& other = backends()[b];
        const uint32_t threads = b > 0 && (b + size_t(precision) + size_t(form)) % 2 == 0 ? 1 : 3;
        EXPECT_TRUE(outcome(c, *other.backend, precision, form, threads) == expected)
            << other.name << " " << threads << " threads " << to_string(precision)
            << (form == Form::summed ? " summed" : " position");
      }
    }
  }
}

TEST(Evaluations, NativeScatterHasTheBitsOfTheGatherOnEveryBackend) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Form form : {Form::summed, Form::position}) {
      const Outcome gather = outcome(hubs, *backends()[0].backend, precision, form, 1);
      for (const NamedBackend& other : backends()) {
        EXPECT_TRUE(outcome(hubs_scattered, *other.backend, precision, form, 2) == gather)
            << other.name << " " << to_string(precision);
      }
    }
  }
}

TEST(Evaluations, AtomicSumsRunOnEveryBackend) {
  const Case atomic = forced("hubs_scatter_atomic", scatter_atomic);
  for (const NamedBackend& other : backends()) {
    const Outcome out = outcome(atomic, *other.backend, Precision::float64, Form::summed, 2);
    const Outcome native =
        outcome(hubs_scattered, *other.backend, Precision::float64, Form::summed, 2);
    ASSERT_EQ(out.vectors.size(), native.vectors.size());
    double furthest = 0;  // velocities: the second third of what was read
    for (size_t i = out.vectors.size() / 3; i < 2 * out.vectors.size() / 3; ++i) {
      furthest = std::max(furthest, std::abs(out.vectors[i].y - native.vectors[i].y));
    }
    EXPECT_LE(furthest, 1e-6) << other.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Effects, ::testing::Range(size_t(0), cases().size()),
                         [](const auto& info) {
                           return std::string(cases()[info.param].effect.name);
                         });

}  // namespace
}  // namespace weft::testing
