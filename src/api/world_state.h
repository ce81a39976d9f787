// A world: records of its cloths and colliders, its time, and the arena that holds its state.
#pragma once

#include <optional>

#include "api/arena.h"
#include "api/context_state.h"

namespace weft {
namespace api {

/// Throws InvalidInput.
void check_world(const WorldDesc&);

struct EventRecord {
  Event event;
  std::string text;
};

/// Names of PhaseTime, in order.
enum Phase { phase_prepare, phase_inputs_and_advance, phase_check, phase_count };

}  // namespace api

inline namespace v0 {

// Hidden: a nested class else inherits the visibility of its public owner.
struct __attribute__((visibility("hidden"))) World::Impl {
  Impl(std::shared_ptr<api::ContextState> owner, const WorldDesc& world_desc);

  api::ClothRecord* find(ClothId) noexcept;
  api::ColliderRecord* find(ColliderId) noexcept;
  Status stale(const char* what, uint32_t index) noexcept;
  ClothId next_cloth_id();

  /// The cloths in arena order with their shape; `substeps` of a frame at most.
  api::ArenaInput arena_input(uint32_t substeps);
  /// Makes the arena anew where inputs have changed its shape. `dt`: of the substep to come.
  Status ensure_built(double dt, uint32_t substeps);
  Status ensure_readable();
  Status run(double dt, uint32_t substeps);
  Status report_not_finite();
  /// What a collider can touch between now and the end of a step of `dt` wakes up, if it moves.
  void wake_touched(const api::ColliderRecord&, double dt);
  void wake_by_colliders(double dt);
  void wake_all() noexcept;
  /// Tells the log of a cloth that wind cannot move.
  void say_if_windless(const api::ClothRecord&);

  api::ClothRecord& bound_of(api::ClothRecord&);
  Stability tightest();
  std::string bound_text(const Stability&, double dt, uint32_t substeps);

  std::shared_ptr<api::ContextState> context;
  WorldDesc desc;
  std::vector<std::unique_ptr<api::ClothRecord>> cloths;  ///< by slot; null: free
  uint32_t
      serial;  ///< in the upper half of every generation: ids of other worlds name nothing here
  std::vector<uint32_t> generations;           ///< of the cloth slots
  std::vector<ClothId> order;                  ///< by creation
  std::vector<api::ColliderRecord> colliders;  ///< by slot; null id: free
  std::vector<uint32_t> collider_generations;
  std::optional<WindDesc> wind;
  bool normals_wanted = false;  ///< of meshes, whose triangles then lie on the device

  std::unique_ptr<api::Arena> arena;
  std::optional<api::ArenaInput> built;  ///< what the arena was made for
  bool dirty = true;                     ///< the arena must be made anew
  /// What the arena's room for results holds of the present.
  enum class Result : uint8_t { none, accelerations, normals } result = Result::none;
  bool starting = false;  ///< some cloth on the device has not moved yet
  double built_dt = 0;    ///< step that the start displacements belong to
  uint32_t built_substeps = 0;
  bool lost = false;  ///< diverged, or the device failed

  double time = 0, time_base = 0;  ///< time = base + frames of one length
  double frame_dt = 0;
  uint64_t frames_of_dt = 0;
  double dt_before = 0;  ///< last substep; 0: none yet

  uint64_t frames = 0, steps = 0;
  uint32_t substeps_most = 0, substeps_last = 0, threads_last = 1;
  double dt_least = 0, step_seconds = 0;
  PhaseTime phases[api::phase_count] = {{"prepare", 0}, {"advance", 0}, {"check", 0}};

  std::vector<api::EventRecord> event_records;
  std::vector<Event> events;
  plan::Plan plan;
  std::vector<PassInfo> passes;
};

}  // namespace v0
}  // namespace weft
