#include "bench/collide_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

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
    grid.material.stiffness = {stiffness, stiffness / 2, stiffness / 40};
    ClothDesc cloth;
    cloth.fabric = take(context_.cook(grid), "grid");
    cloth.pose = {{1, 0, 0.3}, 8, {0, 0.02, 0}};
    cloth.drag = 0.02 / (n * n);
    cloth.spring_damping = 1e-4;
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
  uint64_t found() { return take(world_.near_pairs(), "near pairs").count; }
  size_t crossings() { return io::crossings(positions(), triangles_).size(); }
  double ns_per_particle_step() const {
    const Stats stats = world_.stats();
    return 1e9 * stats.step_seconds / (double(stats.steps) * double(stats.particles));
  }
  /// The fewest substeps of a frame that are stable.
  uint32_t fewest_substeps() {
    return uint32_t(std::ceil(frame / (0.95 * world_.stability().dt_bound)));
  }

  static constexpr double stiffness = 4;  // N/m: soft, so that long steps are stable

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
    course.missed += pairs - (search ? double(sheet.found()) : 0);
  }
  course.ns = sheet.ns_per_particle_step();
  course.crossings = double(sheet.crossings());
  return course;
}

/// Pairs that were near only between the ends of a substep, for each that was at an end: no search
/// of positions finds them.
double passed_between(const Fold& fold, uint32_t substeps, const SelfCollisionDesc& search) {
  Sheet sheet(fold.n, 1, &search);
  double near = 0, passed = 0;
  for (int f = 0; f < fold.frames; ++f) {
    for (uint32_t s = 0; s + 1 < substeps; ++s) sheet.step(frame / substeps);
    const std::vector<double3> before = sheet.positions();
    sheet.step(frame / substeps);
    const std::vector<double3> after = sheet.positions();
    double most = 0;
    for (size_t v = 0; v < after.size(); ++v) most = std::max(most, apart(before[v], after[v]));
    each_pair(after, fold.distance + 2 * most, [&](uint32_t a, uint32_t b) {
      const bool at_end =
          apart(after[a], after[b]) < fold.distance || apart(before[a], before[b]) < fold.distance;
      near += at_end;
      passed += !at_end && least_apart(before[a], before[b], after[a], after[b]) < fold.distance;
    });
  }
  return near > 0 ? passed / near : 0;
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
    {"8 corner grids, window 2", PairSearch::staggered, 2, 8, 2},
    {"2 corner grids", PairSearch::staggered, 2, 2, 0},
    {"1 grid", PairSearch::staggered, 2, 1, 0},
    {"1 grid, window 2", PairSearch::staggered, 2, 1, 2},
};
constexpr size_t few_ways[] = {0, 3, 5};

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

void append_course(const std::string& name, const Fold& fold, const Course& course, double bare,
                   std::vector<Row>& rows) {
  const auto add = [&](const char* metric, const char* unit, double value) {
    rows.push_back({"collide", name, metric, unit, value, value, value, 1});
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
  Fold fold{quick ? 40u : 80u, quick ? 50 : 75, 0};
  fold.distance = 0.75 / (fold.n - 1);
  const uint32_t fewest = Sheet(fold.n, 1, nullptr).fewest_substeps();
  std::vector<Way> chosen(std::begin(ways), std::end(ways));
  if (quick) {
    chosen.clear();
    for (const size_t way : few_ways) chosen.push_back(ways[way]);
  }
  for (const uint32_t times :
       quick ? std::vector<uint32_t>{1, 4} : std::vector<uint32_t>{1, 2, 4, 8}) {
    const uint32_t substeps = times * fewest;
    const std::string name = "folding, " + std::to_string(substeps) + " substeps: ";
    progress << "collide: " << name << "of a frame\n";
    const Course bare = run(fold, substeps, nullptr);
    append_course(name + "none", fold, bare, 0, rows);
    for (const Way& way : chosen) {
      const SelfCollisionDesc desc = desc_of(way, fold.distance);
      append_course(name + way.name, fold, run(fold, substeps, &desc), bare.ns, rows);
    }
    const SelfCollisionDesc complete = desc_of(ways[0], fold.distance);
    const double passed = passed_between(fold, substeps, complete);
    rows.push_back(
        {"collide", name + "complete", "passed_between", "1", passed, passed, passed, 1});
  }
}

}  // namespace weft::bench
