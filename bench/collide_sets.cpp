#include "bench/collide_sets.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "bench/random.h"

namespace weft::bench {

namespace {

template <class T>
T take(Result<T> result, const char* what) {
  if (!result) throw std::runtime_error(std::string(what) + ": " + to_string(result.status()));
  return std::move(*result);
}
void require(Status status, const char* what) {
  if (status != Status::ok) throw std::runtime_error(std::string(what) + ": " + to_string(status));
}

double3 random_point(Random& random, double side) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return {side * (2 * x - 1), side * (2 * y - 1), side * (2 * z - 1)};
}

double dot(double3 a, double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

double3 random_direction(Random& random) {
  constexpr double pi = 3.14159265358979323846;
  const double z = 2 * random.uniform() - 1, angle = 2 * pi * random.uniform();
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

double3 middle_of(const std::vector<double3>& points) {
  double3 sum{0, 0, 0};
  for (const double3& p : points) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  const double n = double(points.size());
  return {sum.x / n, sum.y / n, sum.z / n};
}

}  // namespace

std::vector<double3> uniform_points(uint32_t count, uint64_t seed) {
  Random random(seed);
  std::vector<double3> points;
  for (uint32_t i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back({x, y, z});
  }
  return points;
}

std::vector<double3> crumpled_sheet(uint32_t n, uint32_t folds, double jitter, uint64_t seed) {
  Random random(seed);
  std::vector<double3> points;
  for (uint32_t v = 0; v < n * n; ++v) {
    points.push_back({double(v % n) / (n - 1), double(v / n) / (n - 1), 0});
  }
  for (uint32_t f = 0; f < folds; ++f) {
    const double3 normal = random_direction(random);
    const double offset = dot(normal, middle_of(points)) + 0.2 * (random.uniform() - 0.5);
    for (double3& p : points) {
      const double beyond = dot(normal, p) - offset;
      if (beyond >= 0) continue;
      p = {p.x - 2 * beyond * normal.x, p.y - 2 * beyond * normal.y, p.z - 2 * beyond * normal.z};
    }
  }
  for (double3& p : points) {
    const double3 d = random_point(random, jitter);
    p = {p.x + d.x, p.y + d.y, p.z + d.z};
  }
  return points;
}

std::vector<double3> moved(std::vector<double3> points, uint64_t seed) {
  Random random(seed);
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  for (double3& p : points) p = {p.x + x, p.y + y, p.z + z};
  return points;
}

double points_per_cell(const std::vector<double3>& points, double cell) {
  std::map<std::array<double, 3>, double> cells;
  for (const double3& p : points) {
    cells[{std::floor(p.x / cell), std::floor(p.y / cell), std::floor(p.z / cell)}] += 1;
  }
  double squares = 0;
  for (const auto& [key, count] : cells) squares += count * count;
  return squares / double(points.size());
}

std::string name_of(const SelfCollisionDesc& desc) {
  if (desc.search == PairSearch::complete) return "complete";
  char text[128];
  std::snprintf(text, sizeof text, "staggered, %u %s, h = %g r", desc.grids,
                desc.shifts == GridShifts::corner ? "corner" : "diagonal",
                desc.cell / desc.distance);
  const std::string name = text;
  return desc.window > 0 ? name + ", window " + std::to_string(desc.window) : name + ", no window";
}

Cloud::Cloud(const std::vector<double3>& points, const SelfCollisionDesc& search) {
  ContextDesc context;
  context.backend = BackendKind::omp;
  context.threads = 1;
  context_ = take(Context::create(context), "context");
  WorldDesc desc;
  desc.gravity = {0, 0, 0};
  desc.substeps = 1;
  world_ = take(context_.create_world(desc), "world");
  // At rest they are far apart, so that no pair is excluded.
  std::vector<double3> rest;
  for (size_t i = 0; i < points.size(); ++i)
    rest.push_back({10 * search.distance * double(i), 0, 0});
  NetworkDesc network;
  network.positions = View<double3>(rest);
  ClothDesc cloth;
  cloth.fabric = take(context_.cook(network), "network");
  cloth.positions = View<double3>(points);
  cloth_ = take(world_.create_cloth(cloth), "cloth");
  SelfCollisionDesc anew = search;
  anew.skin = 0;
  require(world_.set_self_collision(anew), "self-collision");
  require(world_.prepare(1e-6), "prepare");
  points_.positions.resize(points.size());
  points_.distance = search.distance;
  require(world_.read_positions(cloth_, points_.positions.data()), "positions");
}

Cloud::Search Cloud::search() {
  Search found{{}, 1e30};
  View<NearPair> pairs;
  for (int i = 0; i < 3; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    pairs = take(world_.near_pairs(true), "near pairs");
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    found.seconds = std::min(found.seconds, time.count());
  }
  found.recall = io::compare_pairs({cloth_}, {points_}, pairs);
  return found;
}

double Cloud::step() {
  require(world_.step(1e-6), "step");  // finds room for its lists
  const double before = world_.stats().step_seconds;
  require(world_.step(1e-6), "step");
  return world_.stats().step_seconds - before;
}

}  // namespace weft::bench
