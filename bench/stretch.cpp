#include "bench/stretch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "bench/stretch_scenes.h"

namespace weft::bench {

namespace {

constexpr int frames = 70, looked_at = 5;  ///< the stretch at the end is the mean of the last ones
constexpr int early = 25;                  ///< frame in which the motion is compared

/// `edge` after 25 frames, of its own springs of 1e5 N/m: explicit Verlet in float64 at 0.9 of the
/// bound (1837 and 3673 substeps a frame): `weft run` of the scene that docs/solvers.md shows.
struct Reference {
  uint32_t n;
  Energies energies;
};
constexpr Reference references[] = {{128, {-0.619038, 5.886909, -6.072766}},
                                    {256, {-0.619987, 5.897242, -6.082069}}};

std::optional<Energies> reference_of(StretchScene scene, uint32_t n) {
  for (const Reference& r : references) {
    if (scene == StretchScene::edge && r.n == n) return r.energies;
  }
  return {};
}

class Rows {
 public:
  explicit Rows(std::string name) : name_(std::move(name)) {}

  void add(const char* metric, const char* unit, std::vector<double> samples) {
    std::sort(samples.begin(), samples.end());
    rows_.push_back({"stretch", name_, metric, unit, samples[samples.size() / 2], samples.front(),
                     samples.back(), static_cast<int>(samples.size())});
  }
  void add(const char* metric, const char* unit, double value) {
    add(metric, unit, std::vector<double>{value});
  }
  void move_to(std::vector<Row>& all) {
    for (Row& row : rows_) all.push_back(std::move(row));
  }

 private:
  std::string name_;
  std::vector<Row> rows_;
};

std::string case_of(StretchScene scene, uint32_t n, const Method& method, uint32_t threads) {
  char name[128];
  const char* on = threads == 1 ? "" : ", 2 threads";
  if (scene == StretchScene::capes) {
    std::snprintf(name, sizeof name, "%s: %s%s", to_string(scene), method.name.c_str(), on);
  } else {
    std::snprintf(name, sizeof name, "%s %u: %s%s", to_string(scene), n, method.name.c_str(), on);
  }
  return name;
}

void measure(StretchScene scene, uint32_t n, const Method& method, uint32_t threads,
             std::vector<Row>& all) {
  StretchRun run(scene, n, method, threads);
  Rows rows(case_of(scene, n, method, threads));
  std::vector<double> milliseconds;
  Stretched end, worst;
  for (int f = 1; f <= frames; ++f) {
    milliseconds.push_back(1e3 * run.frame());
    if (threads > 1) continue;  // the bits are those of one
    const Stretched now = run.stretch();
    worst = {std::max(worst.p99, now.p99), std::max(worst.largest, now.largest)};
    if (f > frames - looked_at) {
      end.p99 += now.p99 / looked_at;
      end.largest += now.largest / looked_at;
    }
    if (f != early) continue;
    const Energies e = run.energies();
    rows.add("height", "m", e.height);
    rows.add("kinetic", "J", e.kinetic);
    rows.add("potential", "J", e.potential);
    if (const auto wanted = reference_of(scene, n)) {
      rows.add("height_error", "mm", 1e3 * (e.height - wanted->height));
      rows.add("kinetic_error", "%", 100 * (e.kinetic / wanted->kinetic - 1));
    }
  }
  rows.add("frame", "ms", milliseconds);
  rows.add("substeps", "1", run.substeps());
  if (threads == 1) {
    rows.add("p99", "%", 100 * end.p99);
    rows.add("largest", "%", 100 * end.largest);
    rows.add("worst_p99", "%", 100 * worst.p99);
    rows.add("worst_largest", "%", 100 * worst.largest);
  }
  rows.move_to(all);
}

Method xpbd(uint32_t substeps, std::vector<uint8_t> ladder) {
  std::string name = "xpbd ";
  name.append(std::to_string(substeps));
  for (size_t k = 0; k < ladder.size(); ++k) {
    name.append(k == 0 ? ", long " : "+").append(std::to_string(ladder[k]));
  }
  return {name, Integrator::xpbd, 1e5, substeps, std::move(ladder)};
}
/// What a scene gets that says no more than "xpbd".
Method automatic() { return {"xpbd, automatic", Integrator::xpbd, 1e5, 0, {automatic_ladder}}; }
Method tethered(Method method) {
  method.name.append(", tethers");
  method.tethered = true;
  return method;
}
Method verlet(double stretch, double shear, double bend) {
  char name[64];
  std::snprintf(name, sizeof name, "verlet %g:%g:%g N/m", stretch, shear, bend);
  return {name, Integrator::verlet, {stretch, shear, bend}, 0, {}};
}

struct Study {
  StretchScene scene;
  uint32_t n;
  std::vector<Method> methods;
  std::vector<Method> on_two_threads;
};

std::vector<Study> studies(bool quick) {
  if (quick) {
    return {{StretchScene::edge, 48, {xpbd(10, {}), xpbd(8, {8, 4}), verlet(80, 8, 80)}, {}}};
  }
  const std::vector<uint8_t> none, two{8, 4}, three{16, 8, 4}, four{32, 16, 8, 4};
  const Method free = automatic();
  return {
      {StretchScene::edge,
       128,
       {xpbd(10, none), xpbd(15, none), xpbd(20, none), xpbd(30, none), xpbd(40, none),
        xpbd(80, none), xpbd(6, two), xpbd(8, two), xpbd(10, two), xpbd(14, two), xpbd(20, two),
        xpbd(28, two), xpbd(40, two), free, verlet(80, 8, 80), verlet(240, 24, 240),
        verlet(800, 80, 800)},
       {xpbd(20, none), xpbd(20, two)}},
      {StretchScene::edge,
       256,
       {xpbd(20, none), xpbd(40, none), xpbd(60, none), xpbd(10, two), xpbd(14, two), xpbd(20, two),
        xpbd(30, two), xpbd(14, three), xpbd(20, three), free, verlet(240, 24, 240)},
       {xpbd(20, two), xpbd(20, three)}},
      {StretchScene::edge,
       512,
       {xpbd(20, three), xpbd(28, three), xpbd(40, three), xpbd(20, four), free},
       {xpbd(20, three)}},
      {StretchScene::pin,
       128,
       {xpbd(20, none), xpbd(30, none), xpbd(40, none), xpbd(14, two), xpbd(20, two), xpbd(24, two),
        free, tethered(xpbd(20, two)), verlet(240, 24, 240), tethered(verlet(240, 24, 240))},
       {}},
      {StretchScene::sphere,
       128,
       {xpbd(10, none), xpbd(14, none), xpbd(20, none), xpbd(8, two), xpbd(12, two), free,
        verlet(80, 8, 80)},
       {}},
      {StretchScene::capes,
       0,
       {xpbd(3, none), xpbd(4, none), xpbd(5, none), xpbd(6, none), free, tethered(xpbd(4, none)),
        verlet(80, 8, 80)},
       {xpbd(5, none)}}};
}

}  // namespace

std::vector<Row> run_stretch(bool quick, std::ostream& progress) {
  std::vector<Row> rows;
  for (const Study& study : studies(quick)) {
    for (const Method& method : study.methods) {
      progress << "stretch: " << case_of(study.scene, study.n, method, 1) << '\n';
      measure(study.scene, study.n, method, 1, rows);
    }
    for (const Method& method : study.on_two_threads) {
      measure(study.scene, study.n, method, 2, rows);
    }
  }
  return rows;
}

}  // namespace weft::bench
