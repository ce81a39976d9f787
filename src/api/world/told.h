// What any thread may ask of a world at any time: kept apart from what the world works with, behind
// a lock that is held for as long as a copy takes and never while anything is called.
#pragma once

#include <mutex>

#include "base/memory_host.h"
#include "weft/world.hpp"

namespace weft::api {

class Told {
 public:
  /// Room for cloths in slots below `slots`, so that add cannot fail. Throws std::bad_alloc.
  void make_room(size_t slots) {
    const std::lock_guard lock(mutex_);
    if (slots > cloths_.size()) cloths_.resize(slots);
  }
  void add(ClothId id, const Bounds& bounds, uint64_t particles, uint64_t springs) noexcept {
    const std::lock_guard lock(mutex_);
    cloths_[id.index] = {id, bounds, particles, springs};
    particles_ += particles;
    springs_ += springs;
  }
  void remove(ClothId id) noexcept {
    const std::lock_guard lock(mutex_);
    Cloth& cloth = cloths_[id.index];
    particles_ -= cloth.particles;
    springs_ -= cloth.springs;
    cloth = {};
  }
  void set_bounds(ClothId id, const Bounds& bounds) noexcept {
    const std::lock_guard lock(mutex_);
    cloths_[id.index].bounds = bounds;
  }
  /// Of `stats` all but the sums over the cloths.
  void set(const Stats& stats, double time, View<Event> events) noexcept {
    const std::lock_guard lock(mutex_);
    stats_ = stats;
    time_ = time;
    events_ = events;
  }

  /// Whether there is such a cloth, and its bounds.
  bool find(ClothId id, Bounds* bounds = nullptr) const noexcept {
    const std::lock_guard lock(mutex_);
    if (!id || id.index >= cloths_.size() || cloths_[id.index].id != id) return false;
    if (bounds) *bounds = cloths_[id.index].bounds;
    return true;
  }
  Stats stats() const noexcept {
    const std::lock_guard lock(mutex_);
    Stats all = stats_;
    all.particles = particles_;
    all.springs = springs_;
    return all;
  }
  double time() const noexcept {
    const std::lock_guard lock(mutex_);
    return time_;
  }
  View<Event> events() const noexcept {
    const std::lock_guard lock(mutex_);
    return events_;
  }

 private:
  struct Cloth {
    ClothId id;
    Bounds bounds{};
    uint64_t particles = 0, springs = 0;
  };

  mutable std::mutex mutex_;
  Vector<Cloth> cloths_;  ///< by slot
  uint64_t particles_ = 0, springs_ = 0;
  Stats stats_{};
  double time_ = 0;
  View<Event> events_;
};

}  // namespace weft::api
