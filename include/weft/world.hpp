// Worlds: cloths, colliders and the time they move in.
#pragma once

#include "weft/cloth_settings.h"
#include "weft/colliders.hpp"
#include "weft/plan.hpp"
#include "weft/self_collision.hpp"

namespace weft {
inline namespace v0 {

/// How the Verlet update keeps its state. Both are the same scheme in exact arithmetic.
enum class Form : uint8_t {
  summed,   ///< d += a dt^2, x += d with d = x_n - x_(n-1): keeps small increments
  position  ///< x' = 2x - x_prev + a dt^2, as the papers write it: loses them to rounding
};
/// The position before the first step.
enum class Start : uint8_t {
  taylor,  ///< x_(-1) = x0 - v0 dt + a0 dt^2/2: global order 2
  lagged   ///< x_(-1) = x0 - v0 dt: global order 1
};

/// How a step is taken (docs/solvers.md).
enum class Integrator : uint8_t {
  verlet,  ///< explicit: springs are forces; the step is bounded
  xpbd     ///< springs are constraints, one pass over them a substep: stable at any step, and what
           ///< it leaves of their stretch goes as its square. Order 1
};
/// In WorldDesc::ladder: chosen by the size of each grid.
constexpr uint8_t automatic_ladder = 255;

struct WorldDesc {
  double3 gravity{0, -9.81, 0};  ///< m/s^2
  Precision precision = Precision::float32;
  Form form = Form::summed;
  Start start = Start::taylor;
  Integrator integrator = Integrator::verlet;
  /// XPBD on grids: long springs that only pull, along rows and columns, between vertices so many
  /// apart; largest first, 2 to 64, ended by 0. They pass tension on faster.
  uint8_t ladder[6] = {automatic_ladder};
  /// Substeps of a step; 0: the fewest with dt <= safety * bound (one without springs); of xpbd
  /// those that keep a hanging sheet from stretching by more than some 3 %, and max_substeps then
  /// drops no time.
  uint32_t substeps = 0;
  /// Most substeps of a step; 0: no limit. A step that needs more is shorter than asked for: the
  /// rest of it is dropped, with an event.
  uint32_t max_substeps = 0;
  double safety = 0.9;                 ///< in (0, 1]
  bool unsafe = false;                 ///< allow a fixed number of substeps beyond the stable bound
  double fixed_dt = 1.0 / 60;          ///< s, > 0: a step of advance()
  uint32_t max_steps_per_advance = 4;  ///< > 0; what is left of a frame then is dropped
  /// Keep the positions before the last step, so that outputs can lie between the two.
  bool interpolate = false;
  Evaluation evaluation = Evaluation::automatic;
  Accumulate accumulate = Accumulate::native;  ///< others need Evaluation::scatter
  bool deterministic = true;                   ///< Accumulate::atomic needs false
  bool profile = false;     ///< Stats::phases tell where a step spends its time, on the host
  double fixed8_range = 1;  ///< full scale of Accumulate::fixed8 in largest spring forces, > 0
};

/// Prescribed motion of pinned vertices: p0 + velocity t + amplitude sin(omega t), t in world time.
struct PinMotion {
  double3 velocity{0, 0, 0};   ///< m/s
  double3 amplitude{0, 0, 0};  ///< m
  double omega = 0;            ///< rad/s
};
/// A pinned vertex. Forces and colliders do not move it.
struct Pin {
  static constexpr uint32_t fixed = ~0u;
  uint32_t vertex = 0;
  uint32_t motion = fixed;  ///< index into ClothDesc::motions, or fixed
};
/// A constant force on one vertex, N.
struct VertexForce {
  uint32_t vertex = 0;
  double3 force{0, 0, 0};
};

/// Drag, damping, sleep: cloth_settings.h.
struct ClothDesc : ClothSettings {
  Fabric fabric;
  Pose pose;
  /// Positions at the start, m, in the world; empty: the fabric's rest shape in `pose`. Rest
  /// lengths always come from the rest shape.
  PointView positions;
  double3 velocity{0, 0, 0};  ///< m/s, of every vertex that `velocities` does not give
  View<double3> velocities;   ///< empty, or one per vertex
  View<Pin> pins;             ///< a vertex at most once
  View<PinMotion> motions;
  View<VertexForce> forces;  ///< several on one vertex add up
  uint64_t user_data = 0;
};

/// Wind on the triangles of grids and meshes. A triangle of area A and unit normal n whose vertices
/// move at v on average feels, with u = velocity - v,
///   (air_density A/2) (normal |u.n| (u.n) n + tangential |u_t| u_t),
/// a third on each vertex. A step never reverses u of a triangle, and where wind balances the other
/// forces it does so at any step. Still air brakes: only a zero `air_density`, or zero `normal` and
/// `tangential`, is no effect at all.
struct WindDesc {
  double3 velocity{0, 0, 0};   ///< m/s
  double air_density = 1.225;  ///< kg/m^3, >= 0
  double normal = 1;           ///< drag coefficient across the surface, >= 0
  double tangential = 0.02;    ///< along it, >= 0
};

/// The largest stable step of a cloth or a world: dt^2 K + 2 dt C = 4 with K and C the largest
/// S_i/m_i + S_j/m_j over the springs, S the summed stiffness (or damping) of a vertex. Wind lowers
/// it as a drag, by a factor of sqrt(2) at most (2 where damping bounds the step). Holds at every
/// deformation, linearly.
struct Stability {
  double dt_bound;        ///< s; infinite when nothing bounds it
  ClothId cloth;          ///< the one that sets the bound
  uint32_t a = 0, b = 0;  ///< its worst spring (a == b: a vertex bound by its drag)
};

enum class EventType : uint8_t {
  non_finite,        ///< a position became NaN or infinite; `vertex` is the first one
  backend_fallback,  ///< the back end asked for had no device
  slept,             ///< a cloth has come to rest (ClothSettings::sleep_speed)
  woke,              ///< and moves again
  time_dropped,      ///< max_steps_per_advance or max_substeps: Stats::time_dropped has grown
  force_overflow,    ///< a spring force left the range of Accumulate::fixed64; `vertex` is an end
  large_stretch,  ///< a spring is stretched by more than 10 times its rest length; `vertex` is an
                  ///< end. Once, until all are below it. A sixteenth of a cloth's springs, or
                  ///< those of 1,024 vertices or triangles, is looked at after each step
  energy_growth,  ///< the springs of a cloth are stretched by twice their rest lengths in the
                  ///< mean square: it gains energy from nothing. Once, until they are not
};
WEFT_API const char* to_string(EventType) noexcept;
struct Event {
  EventType type;
  ClothId cloth;
  uint32_t vertex;
  double time;       ///< s
  const char* text;  ///< valid until the next step
};

/// Wall time of one phase since the world was made. With WorldDesc::profile those of "advance"
/// follow: "advance.reach", ".springs", ".hubs", ".sums", ".particles" and ".survey"
/// (step/pipeline.h).
struct PhaseTime {
  const char* name;
  double seconds;
};
struct Stats {
  uint64_t particles, springs;  ///< springs: unique, undirected
  uint64_t frames, steps;       ///< steps: substeps done so far
  uint32_t substeps_last, substeps_most;
  double dt_last, dt_least;  ///< s
  double step_seconds;       ///< wall time inside step()
  /// CPU time of the threads that worked in step(), s: more than wall time where several did, less
  /// where other programs took the processor. With the caller's jobs: of the whole process
  /// meanwhile. Of a GPU: of the thread that waited for it.
  double cpu_seconds;
  double time_dropped;  ///< s, since the world was made
  uint32_t threads;     ///< most that a step may use; small worlds run on fewer
  View<PhaseTime> phases;
  uint64_t bytes_state, bytes_total;
};

/// Energies (J) and momentum (kg m/s) of the free particles, velocities as in read_velocities.
/// Elastic energy is of every spring; potential is -m g.x. `stretch` is the largest (l - l0)/l0 of
/// a spring of length l and rest length l0, above a billionth of the cloth's longest, bend springs
/// left out, and 0 where none is longer.
struct Mechanics {
  double kinetic, elastic, potential;
  double3 momentum;
  double stretch;
};

// Outputs: where the vertices of a cloth go, described once and written every frame. An output
// writes the bytes of the attributes that it names and no others: what lies between them, texture
// coordinates for example, stays. Vertices come in the caller's order.

/// How an attribute is stored, in the processor's byte order.
enum class Format : uint8_t {
  none,       ///< not written
  f32x3,      ///< three floats
  f32x4,      ///< and a fourth: 1 of positions, 0 of normals
  f16x4,      ///< four half floats, the same
  snorm8x4,   ///< normals only: v = c / 127, the fourth 0
  snorm16x4,  ///< normals only: v = c / 32767, the fourth 0
  oct16x2     ///< normals only: two snorm16 of the octahedral map
};
WEFT_API uint32_t size_of(Format) noexcept;  ///< bytes of an attribute; 0 of none
struct Attribute {
  Format format = Format::none;
  uint32_t offset = 0;  ///< bytes, from the start of the buffer to the attribute of vertex 0
  uint32_t stride = 0;  ///< bytes from vertex to vertex, at least the size of the format
};
struct VertexLayout {
  Attribute position;
  Attribute normal;         ///< zero where a vertex has no area around it, and of networks
  Attribute last_position;  ///< where the last write_outputs put the vertex: for motion vectors
};
struct OutputDesc {
  VertexLayout layout;  ///< interleaved or not; attributes must not overlap
  void* memory =
      nullptr;         ///< start of the buffer, any alignment; only ever written. May come later
  uint64_t bytes = 0;  ///< of the buffer: checked; 0: not known
  uint32_t first_vertex = 0;  ///< the cloth's vertex 0 in the buffer, which many may share
  double3 origin{0, 0, 0};    ///< m; subtracted in double precision before rounding to float
};
/// A box round a cloth.
struct Bounds {
  double3 low, high;  ///< m, in the world; low above high: no vertices
};
/// What advance() did.
struct Advance {
  uint32_t steps = 0;
  /// How far the frame lies from the last step to the next, in [0, 1): the alpha for write_outputs
  /// of a world that interpolates.
  double alpha = 0;
  /// s, world time of what is drawn. With WorldDesc::interpolate it is always one fixed_dt behind
  /// the frames that were passed; without, it is the last step's, up to one fixed_dt behind.
  double time = 0;
};

/// Cloths and colliders that share time, gravity and precision. Used by one thread at a time, not
/// always the same; different worlds of one context may be used by different threads at once. A
/// call while another thread is inside answers wrong_thread; one between begin_step and end_step
/// answers in_flight. Neither changes anything. valid, time, stats, bounds, events and step_done
/// may be called by any thread at any time, by several at once, and never wait: while another
/// thread is inside they answer as after the last call that has ended. What they point to, the
/// events and Stats::phases, is written by the next step: read it when none is made.
///
/// Inputs change between steps. Every failing call leaves the world as it was, but for a step that
/// ends in `diverged`: the world is then readable and of no further use. out_of_memory too leaves
/// it as it was, and the call may be made again when there is memory: a step takes up its inputs or
/// nothing, and takes no memory once it advances; destroy_* need none. A world may be destroyed in
/// a step in flight: it waits for its end. A world holds at most 2^30 particles. Vertices are
/// numbered as the caller gave them.
class WEFT_API World {
 public:
  World() noexcept = default;
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  Result<ClothId> create_cloth(const ClothDesc&) noexcept;
  Status destroy_cloth(ClothId) noexcept;
  /// What the cloth asks for and does not get, as its pins are now: the log was told at its
  /// creation. And in a world with self-collision how many pairs are too near at rest to touch.
  /// Valid until the next call for this cloth.
  Result<View<Diagnostic>> diagnostics(ClothId) noexcept;
  bool valid(ClothId) const noexcept;
  Result<ColliderId> create_sphere(const SphereDesc&) noexcept;
  Result<ColliderId> create_plane(const PlaneDesc&) noexcept;
  Result<ColliderId> create_capsule(const CapsuleDesc&) noexcept;
  Result<ColliderId> create_cylinder(const CylinderDesc&) noexcept;
  Result<ColliderId> create_box(const BoxDesc&) noexcept;
  Result<ColliderId> create_mesh(const MeshColliderDesc&) noexcept;
  Status destroy_collider(ColliderId) noexcept;
  /// Places a collider: `pose` moves its description (spheres, planes, ... as they were given). By
  /// `simulate` it is there at the end of the next step, on the way in between, and rests there
  /// until it is moved again. On the way it turns uniformly, by the shorter way, about its middle
  /// (the centre of the shape or of the mesh's bounds; of a plane the point next to each cloth),
  /// which goes straight. By `teleport` it is there at once.
  Status move_collider(ColliderId, const Pose& pose, Move = Move::simulate) noexcept;

  /// All of the set, or none of it where one is refused; `velocity` counts until the first move.
  Result<ColliderSetId> create_collider_set(const ColliderSetDesc&) noexcept;
  /// As move_collider for each: the same numbers of each shape, radii, lengths and edges within
  /// the larger of 1e-4 and of four units in the last place of the coordinates in float, unless
  /// may_stretch; of `friction`, `velocity` and `layers` nothing is read. What has an axis turns by
  /// the shortest way to the new one, a plane about the line where it meets its new place. Equal
  /// descriptions are no motion. Nothing moves where one is refused.
  Status move_collider_set(ColliderSetId, const ColliderSetDesc&, Move = Move::simulate) noexcept;
  Status destroy_collider_set(ColliderSetId) noexcept;

  /// Pins `vertices` where `targets` (one each, world, m) say: a free vertex is pinned, a pinned
  /// one is moved; the motion runs linearly over the next step (or frame of advance) and then
  /// stops. Of a vertex that is named twice the last target counts. A target where the pin is is no
  /// change.
  Status move_pins(ClothId, View<uint32_t> vertices, PointView targets) noexcept;
  /// Moves every pin of a cloth to where an engine's skinning has its vertex; `targets`: one per
  /// vertex of the cloth, m, in the world.
  Status set_skinned_targets(ClothId, PointView targets) noexcept;
  /// Frees `vertices`; each keeps the displacement of its last substep as velocity.
  Status release_pins(ClothId, View<uint32_t> vertices) noexcept;
  /// Replaces the constant forces of a cloth; several on one vertex add up.
  Status set_forces(ClothId, View<VertexForce>) noexcept;
  Status set_gravity(double3) noexcept;
  /// A cloth without triangles, a network, feels no wind: the log says so.
  Status set_wind(const WindDesc&) noexcept;
  Status clear_wind() noexcept;
  /// Lets cloths meet themselves and each other; replaces what was set before. Wakes all, unless
  /// nothing is another.
  Status set_self_collision(const SelfCollisionDesc&) noexcept;
  Status clear_self_collision() noexcept;
  /// Of a world without self-collision all are 0.
  Result<ContactCounts> contacts() noexcept;
  /// The pairs that the search finds nearer than their distance at the present positions, ascending
  /// by cloth and vertex, each once; `with_excluded`: those of too short a rest distance too. Valid
  /// until the next call. invalid_argument without self-collision.
  Result<View<NearPair>> near_pairs(bool with_excluded = false) noexcept;
  /// Wakes a sleeping cloth. A moving collider that reaches it, a moved or released pin, a change
  /// of its forces, of wind or of gravity wake it too.
  Status wake(ClothId) noexcept;
  Result<bool> asleep(ClothId) noexcept;

  /// Advances by `dt` seconds (>= 0) in substeps of equal length. dt = 0 changes no bit.
  /// unstable_step: nothing was advanced. diverged: an event says which vertex.
  Status step(double dt) noexcept;
  /// Passes a frame of `frame_dt` seconds (>= 0) in steps of WorldDesc::fixed_dt. At most
  /// max_steps_per_advance are made; what they leave of the frame is dropped, with an event. What
  /// was given since the last frame (pins, targets, colliders, sets) belongs to the end of this
  /// one: each step inside finds it at its own place on the way. A failing call owes no time
  /// afterwards.
  Result<Advance> advance(double frame_dt) noexcept;
  /// step(dt) in two halves: the first takes up the inputs and returns, the second waits for the
  /// end. In between only step_done, valid, time, stats, bounds and events may be called. Where the
  /// caller brings jobs, Jobs::launch runs the step; without it begin_step does. begin_step fails
  /// as step does, and nothing has then begun. end_step without begin_step: invalid_argument.
  Status begin_step(double dt) noexcept;
  bool step_done() const noexcept;  ///< end_step would not wait
  Status end_step() noexcept;
  /// Substeps that step(dt) would take, or why it would refuse.
  Result<uint32_t> substeps(double dt) noexcept;

  /// Allocates and uploads what the next step needs, so that the step itself does not.
  Status prepare(double dt) noexcept;
  Stability stability() noexcept;
  Result<Stability> stability(ClothId) noexcept;
  Result<PlanInfo> plan() noexcept;
  Stats stats() const noexcept;
  /// Of the last step, advance or begin_step and end_step, each once; valid until the next.
  View<Event> events() const noexcept;

  /// Errors: a buffer that is too small, or null with a size; strides below the format's size,
  /// attributes that overlap, formats that do not fit. An output goes with its cloth.
  Result<OutputId> bind_output(ClothId, const OutputDesc&) noexcept;
  Status unbind_output(OutputId) noexcept;
  /// For engines that map a new address every frame. `bytes` as in OutputDesc.
  Status set_output_memory(OutputId, void* memory, uint64_t bytes = 0) noexcept;
  /// Writes every output: positions `alpha` of the way from before the last step to after it (below
  /// 1: WorldDesc::interpolate), normals after it. Writes nothing where it fails: an output without
  /// memory, alpha outside of [0, 1].
  Status write_outputs(double alpha = 1) noexcept;
  /// Round all vertices after the last finished step; of a world that interpolates, and before it.
  /// Never waits.
  Result<Bounds> bounds(ClothId) const noexcept;
  Status debug_draw(const struct DebugDraw&) noexcept;  ///< weft/debug_draw.hpp

  double time() const noexcept;
  /// World positions, m, one per vertex; `stride` bytes apart (at least the size of a point).
  Status read_positions(ClothId, double3* out, uint32_t stride = sizeof(double3)) noexcept;
  Status read_positions(ClothId, float3* out, uint32_t stride = sizeof(float3)) noexcept;
  /// m/s. d/dt + a dt/2: second order at the time of the positions. Where a collider or a tether
  /// holds a vertex, the mean of its last displacement and of the next over dt: 0 at rest, and the
  /// collider's own where it goes along. Pins: their motion. Of a cloth that sleeps: 0. Makes two
  /// substeps aside in a world with colliders or tethers, once for all cloths.
  Status read_velocities(ClothId, double3* out) noexcept;
  /// Unit normals of the vertices, weighted by the areas of their triangles; zero where there is no
  /// area. Of networks: zero.
  Status read_normals(ClothId, double3* out, uint32_t stride = sizeof(double3)) noexcept;
  Status read_normals(ClothId, float3* out, uint32_t stride = sizeof(float3)) noexcept;
  /// Forces by mass plus gravity at the current positions, m/s^2, without drag and contact; pins:
  /// 0.
  Status read_accelerations(ClothId, double3* out) noexcept;
  Result<Mechanics> mechanics() noexcept;
  /// FNV-1a 64 over the little-endian bits of all world positions, rounded to the world's
  /// precision, cloth by cloth in order of creation, vertex by vertex, x y z.
  Result<uint64_t> state_hash() noexcept;

  struct Impl;
  explicit World(Impl* made) noexcept : impl_(made) {}

 private:
  Impl* impl_ = nullptr;
};

}  // namespace v0
}  // namespace weft
