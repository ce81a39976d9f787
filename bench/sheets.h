// Worlds that the benchmarks step, through the public interface.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "weft/weft.hpp"

namespace weft::bench {

constexpr int steps_per_call = 8;

/// A context and a world with one cloth; a call of advance() makes `substeps` steps.
class SteppedWorld {
 public:
  struct Options {
    Precision precision = Precision::float32;
    BackendKind backend = BackendKind::omp;
    uint32_t threads = 1;
    uint32_t cloths = 1;  ///< alike, in one world
    double stiffness = 100;
    Evaluation evaluation = Evaluation::gather;
    Accumulate accumulate = Accumulate::native;
    bool profile = false;
    int substeps = steps_per_call;
    std::function<void(WorldDesc&)> begin;  ///< changes the world before it is made
    std::function<void(ClothDesc&)> dress;  ///< changes the cloth before it is made
    std::function<void(Context&, World&, ClothId)> furnish;  ///< adds what else there is
  };
  /// A free sheet of n x n vertices on the unit square with 1 kg, at 0.9 of its stable bound.
  static SteppedWorld sheet(uint32_t n, Stencil, const Options&);
  /// Free particles without springs: what integration takes by itself.
  static SteppedWorld particles(uint32_t count, const Options&);
  static SteppedWorld network(const std::vector<double3>& positions,
                              const std::vector<Spring>& springs, const Options&);
  /// The same from triangles.
  static SteppedWorld mesh(const std::vector<double3>& positions,
                           const std::vector<uint32_t>& triangles, const Options&);

  void advance();
  double particle_steps() const { return double(particles_) * substeps_; }
  double spring_steps() const { return double(directed_springs_) * substeps_; }
  /// Every spring counted once.
  double edge_steps() const { return spring_steps() / 2; }
  int substeps() const { return substeps_; }
  World& world() { return world_; }
  ClothId cloth() const { return cloth_; }
  double particles() const { return double(particles_); }
  /// Bytes that a substep moves at least, each once, neighbours from cache.
  double bytes_per_step();
  const char* isa() const { return context_.info().isa; }

 private:
  SteppedWorld(Context, Fabric, const Options&);

  Context context_;
  World world_;
  ClothId cloth_;
  double dt_ = 0;
  int substeps_ = 0;
  uint64_t particles_ = 0, directed_springs_ = 0;
};

/// Vertices and triangles of the n x n valence-6 sheet, split as the grid's.
struct TriangleSheet {
  std::vector<double3> positions;
  std::vector<uint32_t> triangles;
};
TriangleSheet triangle_sheet(uint32_t n);

}  // namespace weft::bench
