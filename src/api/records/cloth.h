// What a world remembers of a cloth, on the host, in caller order and double.
#pragma once

#include <memory>
#include <memory_resource>

#include "api/records/way.h"
#include "base/memory_host.h"
#include "plan/shape.h"
#include "scene/colours.h"
#include "scene/stretch.h"
#include "weft/world.hpp"

namespace weft::api {

struct PinRecord {
  uint32_t vertex;
  int32_t motion = -1;    ///< index into ClothRecord::motions; -1: none
  bool can_move = false;  ///< has a motion, or was moved: it needs a slot on the device
  bool gliding = false;   ///< travels from `base` to `target` in the next step
  double3 base;           ///< world position without its motion
  double3 target{0, 0, 0};
  Way<double3> way;  ///< where move_pins leads it
};

/// What is known of how far a cloth's springs are stretched: a few are looked at after every frame.
struct StretchWatch {
  uint64_t next = 0;     ///< item to go on with; 0: a look at all begins
  double hair = -1;      ///< m: shorter rest lengths do not count; below 0: not known yet
  scene::Stretches now;  ///< of what was looked at after the last frame
  double longer_squares = 0, rest_squares = 0;  ///< m^2, so far in this look at all
  bool beyond = false;  ///< in this look at all some spring was beyond the limit
  bool told_stretch = false, told_energy = false;
};
/// Largest (l - l0)/l0, and root mean square of it, that no event tells of.
constexpr double large_stretch = 10, large_mean_stretch = 2;

struct ClothRecord : ClothSettings, HostObject {
  explicit ClothRecord(std::pmr::memory_resource* memory)
      : pins(memory), motions(memory), forces(memory), positions(memory), velocities(memory) {}

  const scene::CookedFabric& cooked() const { return *cooked_fabric; }
  /// Element of its first particle on the device.
  int first() const { return static_cast<int>(place.particles); }
  void changed(Part part) { parts_changed |= 1u << static_cast<int>(part); }
  /// Other vertices are pinned than before.
  void repinned() {
    bound_known = false;
    for (auto& part : kept) part.reset();
  }
  const PinRecord* pin_of(uint32_t vertex) const;

  ClothId id;
  uint64_t created = 0;  ///< its place among the cloths of the world, by creation
  Fabric fabric;         // holds the reference
  const scene::CookedFabric* cooked_fabric = nullptr;

  // Rows of the rotation; position in the world = rotation * rest + translate.
  double3 rotation[3];
  double3 translate{0, 0, 0};
  /// Whole metres; device positions are relative to it. It follows the cloth between frames, where
  /// that rounds nothing.
  double3 origin{0, 0, 0};
  /// The first one: what is computed of the rest shape in the device's precision is relative to it,
  /// so that no bit of it depends on where the cloth is when memory is made anew.
  double3 rest_origin{0, 0, 0};
  double extent = 0;        ///< m: from the middle to most of the particles at the start
  double3 middle{0, 0, 0};  ///< local, of the last survey: the median of a sample

  double3 velocity{0, 0, 0};
  uint64_t user_data = 0;
  std::pmr::vector<PinRecord> pins;  ///< ascending vertex
  bool pins_led = false;             ///< some `way` is not at rest
  std::pmr::vector<PinMotion> motions;
  std::pmr::vector<VertexForce> forces;  ///< ascending vertex, each once
  std::pmr::vector<double3>
      positions;  ///< start, world; empty: rest shape. Freed once it has moved
  std::pmr::vector<double3> velocities;  ///< start; empty: `velocity`. Freed once it has moved

  bool scatters = false;      ///< its springs are evaluated once each (evaluation.h)
  double force_scale = 0;     ///< N: of one spring (evaluation.h)
  uint32_t most_springs = 0;  ///< of a vertex

  std::shared_ptr<const scene::Colours> colours;  ///< XPBD: its springs (projection.h)
  double chain = 0;                               ///< 1/m: length / (spring length)^2

  bool asleep = false;
  double calm = 0;   ///< s: how long nothing has been faster than sleep_speed
  int settling = 0;  ///< substeps until a sleeper's state is in every buffer

  // Of the last survey.
  double3 low{0, 0, 0}, high{0, 0, 0};  ///< local; low above high: nothing is finite
  double furthest = 0;                  ///< m: longest way of a particle in the last substep
  bool broken = false;                  ///< a position is not finite

  StretchWatch stretch;

  uint32_t parts_changed = 0;  ///< bit k: the device's entries of Part k are out of date
  bool buried = false;         ///< destroyed, but still in the arena
  bool moved = false;          ///< a step has been made: the device holds its state
  ClothCounts place{};         ///< where its elements begin in the arrays of the device
  // State while the device memory is being remade: local, storage order, as the form keeps it.
  Vector<double3> saved_x, saved_d, saved_before;
  Bounds bounds{}, bounds_before{};  ///< what is told of the last step, and of the one before
  bool told_asleep = false;

  /// What parts have worked out from the fabric and from which vertices are pinned; null: not yet.
  mutable std::shared_ptr<const void> kept[part_count];
  Vector<scene::CookedDiagnostic> remarks;  ///< of World::diagnostics, and what it points to
  Vector<Diagnostic> told_remarks;

  /// Pairs that are nearer than a distance at rest, and that distance; below 0: not counted yet.
  mutable double near_rest_distance = -1;
  mutable uint64_t near_rest_pairs = 0;

  bool bound_known = false;
  double bound_dt = 0;
  uint32_t bound_a = 0, bound_b = 0;
};

/// m: the search for near particles calls 1e15 m endless; throws InvalidInput above.
constexpr double most_collision_distance = 1e12;
void check_collision_distance(double distance, const char* field);
/// m: nearer than this its particles touch.
double collision_distance_of(const ClothRecord&, const SelfCollisionDesc&);
/// Pairs of this cloth that self-collision leaves out. Counted once for each distance.
uint64_t excluded_pairs(const ClothRecord&, const SelfCollisionDesc&);

/// Rest position of a vertex in the pose of the cloth, in the world.
double3 posed(const ClothRecord&, uint32_t vertex);
/// Where a vertex is at the start.
double3 start_position(const ClothRecord&, uint32_t vertex);
/// Displacement of a motion at time t.
double3 motion_offset(const PinMotion&, double t);
double3 motion_velocity(const PinMotion&, double t);

/// Sorts forces by vertex and adds up those on one; throws InvalidInput.
void checked_forces(View<VertexForce>, uint32_t vertices, std::pmr::vector<VertexForce>& out);

/// Substeps after which what a sleeper last wrote is in every buffer.
constexpr int substeps_to_settle = 3;
void wake(ClothRecord&);
/// After a frame of `dt` in substeps of `substep`: puts a calm cloth to sleep.
void notice_rest(ClothRecord&, double dt, double substep);

/// Checks a description against its fabric and makes a record of it; throws InvalidInput.
void fill_record(const ClothDesc&, ClothRecord&);
/// Lets the pins of a new cloth start where their motion is at `time`.
void start_motions(ClothRecord&, double time);

}  // namespace weft::api
