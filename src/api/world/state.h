// A world: records of its cloths and colliders, its time, and the arena that holds its state.
#pragma once

#include <atomic>
#include <optional>

#include "api/arena/arena.h"
#include "api/context/context_state.h"
#include "api/records/outputs.h"
#include "api/context/runner.h"
#include "api/context/slots.h"
#include "api/world/event_list.h"
#include "api/world/told.h"

namespace weft {
namespace api {

/// Throws InvalidInput.
void check_world(const WorldDesc&);

struct ColliderSetRecord {
  ColliderSetId id;
  Vector<ColliderId> members;  ///< spheres, planes, capsules, cylinders, boxes
};

/// A step between its begin and its end. The thread that makes it touches nothing of the world but
/// this and the arena.
struct Flight {
  bool active = false;  ///< between begin_step and end_step
  double dt = 0;        ///< s, of the whole step
  double way = 1;       ///< how much of the frame's inputs is behind at its end
  uint32_t substeps = 0;
  Status outcome = Status::ok;
  double seconds = 0;            ///< how long the arena worked
  double cpu_seconds = 0;        ///< and its threads
  std::atomic<bool> done{true};  ///< set by the thread that made the step
  std::atomic<bool> left{true};  ///< the last that this thread touches
};

/// A step that is about to be made.
struct Stride {
  double dt = 0;  ///< s
  uint32_t substeps = 0;
  double dropped = 0;  ///< s that max_substeps takes off
};

/// A force beyond the range of fixed64.
struct Overflow {
  ClothId cloth;
  uint32_t vertex = 0;
  int substep = 0;
  Text text;
};

/// Names of PhaseTime, in order.
enum Phase { phase_prepare, phase_inputs_and_advance, phase_check, phase_count };
/// Of the parts of a frame, with the phases before them.
constexpr int phases_with_laps = phase_count + lap_count;

}  // namespace api

inline namespace v0 {

// Hidden: a nested class else inherits the visibility of its public owner.
struct __attribute__((visibility("hidden"))) World::Impl : HostObject {
  Impl(std::shared_ptr<api::ContextState> owner, const WorldDesc& world_desc);

  api::ClothRecord* find(ClothId) noexcept;
  api::ColliderRecord* find(ColliderId) noexcept;
  api::ColliderSetRecord* find(ColliderSetId) noexcept;
  api::OutputRecord* find(OutputId) noexcept;
  Status stale(const char* what, uint32_t index) noexcept;

  /// The cloths in arena order with their shape; `substeps` of a frame at most.
  api::ArenaInput arena_input(uint32_t substeps) const;
  /// Makes the arena anew where inputs have changed its shape. `dt`: of the substep to come.
  Status ensure_built(double dt, uint32_t substeps);
  /// Destroys the record of a cloth that is no longer in `order`; needs no memory.
  Status bury(uint32_t slot);
  Status ensure_readable();
  /// Accelerations and normals are made when they are asked for, for all cloths at once.
  Status make_result(api::StateArray);
  /// What a substep more would do where colliders or tethers may hold a vertex, else nothing.
  Status probe(const api::ClothRecord&, Vector<api::Probed>& out);
  /// Triangles of meshes go to the device when their normals are first asked for.
  void want_normals();
  /// A step in three parts: what the world does before the arena works, the arena's work, which may
  /// be another thread's, and what the world does after it.
  /// `way`: how much of what was given for this frame is behind at the end of the step.
  Status begin(const api::Stride&, double way);
  void fly() noexcept;
  Status land();
  Status run(const api::Stride&, double way);
  /// Substeps of a step of `dt`; throws InvalidInput.
  Status stride_of(double dt, api::Stride&);
  /// Targets of what is led, for the step to come.
  void aim(double way);
  /// What is led has taken its step; `way` as in aim.
  void arrive(double way);
  /// The frame is over: what was given for it and has not been reached waits for the next step.
  void end_inputs();
  void begin_events() noexcept;
  /// World time of what write_outputs(alpha) draws, s.
  double drawn_time(double alpha) const;
  void drop_time(double seconds, const char* why);
  void start_flight();
  void wait_for_flight() noexcept;
  /// Tells all threads what has become of the world (told.h).
  void publish() const noexcept;
  void tell_who_sleeps(api::ClothRecord&);
  Status tell_of_stretch();
  void start_bounds_of(api::ClothRecord&) const;
  void publish_bounds(api::ClothRecord&) const;
  Status report_not_finite();
  Status report_first_not_finite();
  /// A force beyond the range of fixed64: diverged, or ok when there was none.
  Status find_overflow(api::Overflow&);
  Status read_mean_velocities(ClothId, double3* out);
  /// Of one in the last step.
  Status report_overflow();
  /// What a collider can touch between now and the end of a step of `dt` wakes up, if it moves.
  void wake_touched(const api::ColliderRecord&, double dt);
  void wake_by_colliders(double dt);
  /// Sleepers that a cloth may meet and whose bounds are near, or `way` from it; those near them.
  void wake_neighbours(const api::ClothRecord&, double way);
  void wake_by_cloths(double substep);
  ColliderId add(api::ColliderRecord);
  void move(api::ColliderRecord&, const api::Placed& to, Move);
  void stretch(api::ColliderRecord&, const api::ColliderRecord& other);
  void remove(api::ColliderRecord&);
  void wake_all() noexcept;
  /// Fills `pairs` with those that self-collision finds at the present positions.
  Status find_pairs(bool with_excluded);
  /// What was worked out to be read is of other inputs.
  void forget_results() noexcept {
    result = Result::none;
    probed = false;
  }
  /// Leads pins to targets; free vertices are pinned first. `vertices` and `targets` are checked.
  Status lead_pins(api::ClothRecord&, View<uint32_t> vertices, const PointView& targets);
  Status pin_free(api::ClothRecord&, const std::pmr::vector<uint32_t>& vertices);
  /// Tells the log of a cloth that wind cannot move.
  void say_if_windless(const api::ClothRecord&);

  api::ClothRecord& bound_of(api::ClothRecord&);
  Stability tightest();
  Text bound_text(const Stability&, double dt, uint32_t substeps);

  std::shared_ptr<api::ContextState> context;
  WorldDesc desc;
  Vector<std::unique_ptr<api::ClothRecord>> cloths;  ///< by slot; null: free
  api::Slots<ClothId> cloth_ids;
  Vector<std::unique_ptr<api::ClothRecord>> graves;  ///< destroyed, but the arena is made for them
  Vector<ClothId> order;                             ///< by creation
  Vector<api::ColliderRecord> colliders;             ///< by slot; null id: free
  api::Slots<ColliderId> collider_ids;
  Vector<api::ColliderSetRecord> collider_sets;  ///< by slot; null id: free
  api::Slots<ColliderSetId> collider_set_ids;
  Vector<api::OutputRecord> outputs;  ///< by slot; null id: free
  api::Slots<OutputId> output_ids;
  std::optional<WindDesc> wind;
  std::optional<SelfCollisionDesc> self_collision;
  Vector<NearPair> pairs;       ///< what near_pairs() points to
  bool normals_wanted = false;  ///< of meshes, whose triangles then lie on the device

  std::unique_ptr<api::Arena> arena;
  std::optional<api::ArenaInput> built;  ///< what the arena was made for
  bool dirty = true;                     ///< the arena must be made anew
  /// What the arena's room for results holds of the present.
  enum class Result : uint8_t { none, accelerations, normals } result = Result::none;
  bool probed = false;    ///< the arena knows what the next substep would do
  bool starting = false;  ///< some cloth on the device has not moved yet
  double built_dt = 0;    ///< step that the start displacements belong to
  uint32_t built_substeps = 0;
  bool lost = false;  ///< diverged, or the device failed

  std::atomic<const void*> inside{nullptr};  ///< the thread that is inside (call_guard.h)
  std::atomic<const char*> inside_for{""};   ///< the call that it makes
  mutable api::Told told;
  api::Flight flight;

  double time = 0, time_base = 0;  ///< time = base + frames of one length
  double frame_dt = 0;
  uint64_t frames_of_dt = 0;
  double dt_before = 0;  ///< last substep; 0: none yet

  uint64_t frames = 0, steps = 0;
  uint32_t substeps_most = 0, substeps_last = 0, threads_last = 1;
  double dt_least = 0, step_seconds = 0, cpu_seconds = 0;
  double time_owed = 0, time_dropped = 0;  ///< s, of advance()
  PhaseTime phases[api::phases_with_laps] = {
      {"prepare", 0},         {"advance", 0},         {"check", 0},        {"advance.reach", 0},
      {"advance.springs", 0}, {"advance.hubs", 0},    {"advance.sums", 0}, {"advance.particles", 0},
      {"advance.survey", 0},  {"advance.contacts", 0}};
  StageClock clock;

  api::EventList events;
  plan::Plan plan;
  Vector<PassInfo> passes;
  Vector<EvaluationInfo> evaluations;

  api::Runner runner;  ///< last: it must have ended before anything else goes
};

}  // namespace v0
}  // namespace weft
