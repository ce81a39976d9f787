#include "bench/collide_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <unordered_map>

#include "bench/collide_sets.h"
#include "io/crossings.h"

namespace weft::bench {

namespace {

constexpr double frame = 1.0 / 60;

template <class T>
T take(Result<T> result, const char* what) {
  if (!result) throw std::runtime_error(std::string(what) + ": " + to_string(result.status()));
  return std::move(*result);
}
void require(Status status, const char* what) {
  if (status != Status::ok) throw std::runtime_error(std::string(what) + ": " + to_string(status));
}

double apart(double3 a, double3 b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt((x * x + y * y) + z * z);
}

/// A sheet of 1 m that stands a little askew above a plane.
class Sheet {
 public:
  /// `search`: null: it passes through itself.
  Sheet(uint32_t n, uint32_t substeps, const SelfCollisionDesc* search) : n_(n) {
    ContextDesc context;
    context.backend = BackendKind::omp;
    context.threads = 1;
    context_ = take(Context::create(context), "context");
    WorldDesc desc;
    desc.substeps = substeps;
    world_ = take(context_.create_world(desc), "world");
    GridDesc grid;
    grid.rows = grid.columns = n;
    grid.material.mass.value = 0.2;
    grid.material.stiffness = {stiffness, stiffness / 2, stiffness / 20};
    ClothDesc cloth;
    cloth.fabric = take(context_.cook(grid), "grid");
    cloth.pose = {{1, 0, 0.3}, 8, {0, 0.02, 0}};
    cloth.drag = 0.02 / (n * n);
    cloth.spring_damping = 5e-4;
    cloth.velocity = {0, -2, 0};
    cloth_ = take(world_.create_cloth(cloth), "cloth");
    PlaneDesc ground;
    ground.friction = 0.5;
    take(world_.create_plane(ground), "plane");
    if (search) require(world_.set_self_collision(*search), "self-collision");
    triangles_.resize(size_t(cloth.fabric.triangle_count()));
    require(cloth.fabric.read_triangles(0, triangles_.size(), triangles_[0].data()), "triangles");
  }

  void step(double dt) { require(world_.step(dt), "step"); }
  std::vector<double3> positions() {
    std::vector<double3> points(size_t(n_) * n_);
    require(world_.read_positions(cloth_, points.data()), "positions");
    return points;
  }
  View<NearPair> near_pairs() { return take(world_.near_pairs(), "near pairs"); }
  size_t crossings() { return io::crossings(positions(), triangles_).size(); }
  double ns_per_particle_step() const {
    const Stats stats = world_.stats();
    return 1e9 * stats.step_seconds / (double(stats.steps) * double(stats.particles));
  }
  /// The fewest substeps of a frame that are stable.
  uint32_t fewest_substeps() {
    return uint32_t(std::ceil(frame / (0.95 * world_.stability().dt_bound)));
  }

  static constexpr double stiffness = 25;  // N/m

 private:
  uint32_t n_;
  Context context_;
  World world_;
  ClothId cloth_;
  std::vector<std::array<uint32_t, 3>> triangles_;
};

/// Pairs that are near and not kept near by springs: those of the flat sheet are further apart.
template <class Use>
void each_pair(const std::vector<double3>& points, double reach, Use use) {
  io::each_near_pair({{points, reach, true, true, ~0u}},
                     [&](const io::MeetingPair& p) { use(p.vertex_a, p.vertex_b); });
}

/// The least distance of two points that move straight from `a0`, `b0` to `a1`, `b1`.
double least_apart(double3 a0, double3 b0, double3 a1, double3 b1) {
  const double3 d{a0.x - b0.x, a0.y - b0.y, a0.z - b0.z};
  const double3 e{a1.x - b1.x - d.x, a1.y - b1.y - d.y, a1.z - b1.z - d.z};
  const double square = e.x * e.x + e.y * e.y + e.z * e.z;
  const double along = -(d.x * e.x + d.y * e.y + d.z * e.z);
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  return apart({d.x + t * e.x, d.y + t * e.y, d.z + t * e.z}, {0, 0, 0});
}

struct Fold {
  uint32_t n;
  int frames;
  int first, last;  ///< pairs are followed from the one frame to before the other
  double distance;
};

/// What a run found at the ends of its frames.
struct Course {
  double pairs = 0, missed = 0;  ///< of all frames
  double deep = 0;               ///< of these, nearer than half the distance
  double least = 1;              ///< of all pairs, in distances
  double ns = 0, crossings = 0;
};

Course run(const Fold& fold, uint32_t substeps, const SelfCollisionDesc* search) {
  Sheet sheet(fold.n, substeps, search);
  Course course;
  for (int f = 0; f < fold.frames; ++f) {
    sheet.step(frame);
    double pairs = 0;
    const std::vector<double3> points = sheet.positions();
    each_pair(points, fold.distance, [&](uint32_t a, uint32_t b) {
      const double d = apart(points[a], points[b]) / fold.distance;
      ++pairs;
      course.deep += d < 0.5;
      course.least = std::min(course.least, d);
    });
    course.pairs += pairs;
    course.missed += pairs - (search ? double(sheet.near_pairs().count) : 0);
  }
  course.ns = sheet.ns_per_particle_step();
  course.crossings = double(sheet.crossings());
  return course;
}

/// Pairs that come near, from then until they part.
struct Encounters {
  double all = 0;     ///< that are over
  double missed = 0;  ///< of these, that no search of any substep found
  double looks = 0;   ///< substeps that they lasted, altogether
  /// Pairs that were near only between two substeps, by a tenth of the distance or more: no search
  /// of positions finds them.
  double passed = 0;
};

/// Follows the pairs of a run from substep to substep.
class Follower {
 public:
  explicit Follower(double distance) : distance_(distance) {}

  void look(Sheet& sheet) {
    const std::vector<double3> now = sheet.positions();
    ++substep_;
    double most = 0;
    for (size_t v = 0; v < last_.size(); ++v) most = std::max(most, apart(last_[v], now[v]));
    each_pair(now, distance_ + 2 * most, [&](uint32_t a, uint32_t b) { see(a, b, now); });
    const View<NearPair> found = sheet.near_pairs();
    for (uint32_t i = 0; i < found.count; ++i) {
      const auto pair = open_.find(key(found[i].vertex_a, found[i].vertex_b));
      if (pair != open_.end()) pair->second.found = true;
    }
    for (auto pair = open_.begin(); pair != open_.end();) {
      pair = pair->second.seen == substep_ ? std::next(pair) : close(pair);
    }
    last_ = now;
  }
  const Encounters& counts() const { return counts_; }

 private:
  struct Open {
    uint64_t begun, seen;
    bool found;
  };
  using Pairs = std::unordered_map<uint64_t, Open>;

  static uint64_t key(uint32_t a, uint32_t b) { return uint64_t(a) << 32 | b; }

  void see(uint32_t a, uint32_t b, const std::vector<double3>& now) {
    if (apart(now[a], now[b]) < distance_) {
      open_.try_emplace(key(a, b), Open{substep_, substep_, false}).first->second.seen = substep_;
    } else if (!last_.empty() && apart(last_[a], last_[b]) >= distance_) {
      counts_.passed += least_apart(last_[a], last_[b], now[a], now[b]) < 0.9 * distance_;
    }
  }
  Pairs::iterator close(Pairs::iterator pair) {
    ++counts_.all;
    counts_.missed += !pair->second.found;
    counts_.looks += double(pair->second.seen - pair->second.begun + 1);
    return open_.erase(pair);
  }

  double distance_;
  uint64_t substep_ = 0;
  std::vector<double3> last_;
  Pairs open_;
  Encounters counts_;
};

Encounters follow(const Fold& fold, uint32_t substeps, const SelfCollisionDesc& search) {
  Sheet sheet(fold.n, 1, &search);
  Follower follower(fold.distance);
  for (int f = 0; f < fold.last; ++f) {
    for (uint32_t s = 0; s < substeps; ++s) {
      sheet.step(frame / substeps);
      if (f >= fold.first) follower.look(sheet);
    }
  }
  return follower.counts();
}

struct Way {
  const char* name;
  PairSearch search;
  double cells;
  uint32_t grids, window;
};
constexpr Way ways[] = {
    {"complete", PairSearch::complete, 2, 8, 0},
    {"8 corner grids", PairSearch::staggered, 2, 8, 0},
    {"8 corner grids, window 8", PairSearch::staggered, 2, 8, 8},
    {"2 corner grids", PairSearch::staggered, 2, 2, 0},
    {"1 grid", PairSearch::staggered, 2, 1, 0},
    {"1 grid, window 2", PairSearch::staggered, 2, 1, 2},
};
constexpr size_t few_ways[] = {0, 5};

SelfCollisionDesc desc_of(const Way& way, double distance) {
  SelfCollisionDesc desc;
  desc.search = way.search;
  desc.distance = distance;
  desc.cell = way.cells * distance;
  desc.grids = way.grids;
  desc.window = way.window;
  desc.friction = 0.2;
  return desc;
}

void add_figure(const std::string& name, const char* metric, const char* unit, double value,
                std::vector<Row>& rows) {
  rows.push_back({"collide", name, metric, unit, value, value, value, 1});
}

void append_encounters(const std::string& name, const Encounters& e, std::vector<Row>& rows) {
  const double all = std::max(e.all, 1.0);
  add_figure(name, "encounters", "1", e.all, rows);
  add_figure(name, "encounters_missed", "1", e.missed / all, rows);
  add_figure(name, "encounters_between_substeps", "1", e.passed / all, rows);
  add_figure(name, "substeps_per_encounter", "1", e.looks / all, rows);
}

void append_course(const std::string& name, const Fold& fold, const Course& course, double bare,
                   std::vector<Row>& rows) {
  const auto add = [&](const char* metric, const char* unit, double value) {
    add_figure(name, metric, unit, value, rows);
  };
  add("pairs_per_frame", "1", course.pairs / fold.frames);
  add("missed", "1", course.pairs > 0 ? course.missed / course.pairs : 0);
  add("nearer_than_half", "1", course.pairs > 0 ? course.deep / course.pairs : 0);
  add("least_distance", "r", course.least);
  add("crossings", "1", course.crossings);
  add("ns_per_particle_step", "ns", course.ns);
  if (bare > 0) add("cost", "1", course.ns / bare);
}

}  // namespace

void append_folding(bool quick, std::ostream& progress, std::vector<Row>& rows) {
  Fold fold{quick ? 32u : 40u, 40, 12, quick ? 20 : 28, 0};
  fold.distance = 0.95 / (fold.n - 1);
  const uint32_t fewest = Sheet(fold.n, 1, nullptr).fewest_substeps();
  std::vector<Way> chosen(std::begin(ways), std::end(ways));
  if (quick) {
    chosen.clear();
    for (const size_t way : few_ways) chosen.push_back(ways[way]);
  }
  for (const uint32_t times : {1u, 2u, 4u}) {
    if (quick && times > 2) break;
    const uint32_t substeps = times * fewest;
    const std::string name = "folding, " + std::to_string(substeps) + " substeps: ";
    progress << "collide: " << name << "of a frame\n";
    const Course bare = run(fold, substeps, nullptr);
    append_course(name + "none", fold, bare, 0, rows);
    for (const Way& way : chosen) {
      const SelfCollisionDesc desc = desc_of(way, fold.distance);
      append_course(name + way.name, fold, run(fold, substeps, &desc), bare.ns, rows);
      append_encounters(name + way.name, follow(fold, substeps, desc), rows);
    }
  }
}

}  // namespace weft::bench
