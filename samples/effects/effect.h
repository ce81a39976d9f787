// An effect of weft as a row of a table: what makes it used, what leaves it without effect, how a
// scene file names it. Benchmarks and tests loop over the table of effects.h.
//
// A row is written for cloths at the unit square of the plane z = 0 in a world that pulls along
// -z. Each cloth has more than 256 vertices, and is free or pinned.
#pragma once

#include "weft/weft.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

namespace weft::samples {

constexpr double3 down{0, 0, -9.81};  ///< gravity, m/s^2

/// What a row works on.
struct Stage {
  Context& context;
  World& world;
  std::vector<ClothId> cloths;
  std::vector<ColliderId> colliders;  ///< that the row has added
  bool fine = false;                  ///< collider meshes as large as a game's, to be timed
};

/// What is done to cloths and their world; nothing where a pointer is null. Arrays that `dress`
/// names are static.
struct Change {
  const char* line = nullptr;                 ///< its line of `weft bench effects`, if it is timed
  void (*begin)(WorldDesc&) = nullptr;        ///< before the world is made
  void (*dress)(ClothDesc&) = nullptr;        ///< before a cloth is made
  void (*furnish)(Stage&) = nullptr;          ///< when all cloths are there
  void (*lead)(Stage&, int frame) = nullptr;  ///< before each step, frames from 1 to 12; not timed

  constexpr explicit operator bool() const { return begin || dress || furnish || lead; }
};

/// Plain constants, for the compiler's sake. What is left over of an array is empty.
struct Effect {
  const char* name = "";  ///< of tests, golden hashes and seeds of the fuzzer
  Change used = {};       ///< changes the motion
  Change null[3] = {};    ///< each changes no bit of any cloth
  Change timed[1] = {};   ///< other states that have a price
  Change needs = {};  ///< is there with and without: pins, for example. A line: prices add to it
  const char* cloth_keys = "";     ///< `needs` and `used` as members of a scene's cloth
  const char* scene_keys[3] = {};  ///< and of the scene, in pieces that follow each other

  constexpr bool has_keys() const { return *cloth_keys || scene_keys[0]; }
};

/// Several changes at once, in order.
using Changes = std::vector<const Change*>;

inline void begin(const Changes& changes, WorldDesc& world) {
  for (const Change* c : changes) {
    if (c->begin) c->begin(world);
  }
}
inline void dress(const Changes& changes, ClothDesc& cloth) {
  for (const Change* c : changes) {
    if (c->dress) c->dress(cloth);
  }
}
inline void furnish(const Changes& changes, Stage& stage) {
  for (const Change* c : changes) {
    if (c->furnish) c->furnish(stage);
  }
}
inline void lead(const Changes& changes, Stage& stage, int frame) {
  for (const Change* c : changes) {
    if (c->lead) c->lead(stage, frame);
  }
}

inline void check(Status status) {
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}
template <class T>
T take(Result<T> result) {
  check(result.status());
  return std::move(*result);
}

}  // namespace weft::samples
