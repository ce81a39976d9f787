// What the driver knows of the objects that it has made.
#pragma once

#include "random.h"

#include "weft/weft.hpp"

#include <memory>
#include <vector>

namespace weft_tests::driver {

struct ModelCloth {
  weft::ClothId id;
  uint32_t vertices = 0, render_vertices = 0;
  uint64_t born = 0;  ///< frames before it
  std::vector<bool> pinned;
  bool has_motions = false;  ///< of pins
  bool told_asleep = false;  ///< by events
  bool seen_asleep = false;  ///< before the last step
  uint64_t seen_positions = 0;
};

struct ModelSet {
  weft::ColliderSetId id;
  std::vector<weft::SphereDesc> spheres;
  std::vector<weft::PlaneDesc> planes;
  std::vector<weft::CapsuleDesc> capsules;
  std::vector<weft::CylinderDesc> cylinders;
  std::vector<weft::BoxDesc> boxes;

  weft::ColliderSetDesc desc() const {
    weft::ColliderSetDesc d;
    d.spheres = spheres;
    d.planes = planes;
    d.capsules = capsules;
    d.cylinders = cylinders;
    d.boxes = boxes;
    return d;
  }
};

/// The buffer has exactly the bytes that the output may reach, and a few before and behind.
struct ModelOutput {
  weft::OutputId id;
  weft::ClothId cloth;
  uint32_t vertices = 0;
  weft::OutputDesc desc;
  std::unique_ptr<std::vector<unsigned char>> memory, copy;
  static constexpr size_t guard = 13;
};

/// All that can be seen of a world; equal before and after a call that fails.
struct Seen {
  uint64_t state = 0;  ///< positions, velocities, who sleeps; 0 while a step is in flight
  double time = 0, dropped = 0;
  uint64_t frames = 0, steps = 0, particles = 0, springs = 0;
  uint64_t bounds = 0;

  uint64_t digest() const {
    Digest d;
    d.add(state);
    d.add(time);
    d.add(dropped);
    d.add(frames);
    d.add(steps);
    d.add(particles);
    d.add(springs);
    d.add(bounds);
    return d.value();
  }
};

struct ModelWorld {
  weft::World world;
  weft::WorldDesc desc;
  weft::double3 at{0, 0, 0};  ///< m: where its things are
  size_t home = 0;            ///< its context
  std::vector<ModelCloth> cloths;
  std::vector<weft::ColliderId> colliders;
  std::vector<ModelSet> sets;
  std::vector<ModelOutput> outputs;
  std::vector<weft::ClothId> dead_cloths;
  std::vector<weft::ColliderId> dead_colliders;
  std::vector<weft::ColliderSetId> dead_sets;
  std::vector<weft::OutputId> dead_outputs;
  uint32_t number = 0;    ///< of the call that made it
  bool collides = false;  ///< it has self-collision
  bool in_flight = false;
  bool lost = false;  ///< diverged
  double flight_dropped = 0;
  Seen seen;
  bool is_known = false;  ///< `seen` is how it is now
  uint64_t seen_events = Digest().value(), seen_frames = 0;
};

}  // namespace weft_tests::driver
