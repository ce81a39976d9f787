// The device memory of a world: cut by the plan (plan/cutter.h), filled from the records, advanced
// by the back end. One class per precision behind one interface.
#pragma once

#include <memory>

#include "api/records/cloth.h"
#include "api/records/collider.h"
#include "api/context/context_state.h"
#include "base/memory_host.h"
#include "plan/plan.h"
#include "step/backend.h"

namespace weft::api {

/// The cloths and colliders that an arena is made for, in arena order, and how they are stepped.
struct ArenaInput {
  const WorldDesc* world;
  Vector<ClothRecord*> cloths;  ///< by kernel, then by creation
  const Vector<ColliderRecord>* colliders;
  const WindDesc* wind;                             ///< null: none
  const SelfCollisionDesc* self_collision;          ///< null: none
  Vector<const scene::CookedColliderMesh*> meshes;  ///< each that a collider uses, once
  Vector<size_t> mesh_of_collider;                  ///< by mesh collider, into `meshes`
  plan::WorldShape shape;
};

/// Kernel that a cloth is advanced by.
KernelKind kind_of(const ClothRecord&);
/// And its numbers for the plan; `fans`: with the triangles around its vertices.
plan::ClothShape shape_of(const ClothRecord&, Accumulation, bool fans);

struct FrameInput {
  int substeps;
  double dt, dt_before;  ///< s, of a substep
  double time;           ///< s, at the start of the frame
  Workers workers;
};

/// What a particle would do in a substep more.
struct Probed {
  double3 displacement;  ///< m
  bool held;             ///< by a collider or, perhaps, by a tether
};

enum class StateArray : uint8_t { position, displacement, acceleration, normal };

/// Where the vertices of a cloth go, and how.
struct VertexTarget {
  double alpha;
  double3 shift;  ///< m, from the cloth's local frame to the buffer's
  Vec3<float>* last;
  VertexAttribute position, normal, last_position;
};

/// The first spring whose force left the range of fixed64: elements of its ends, and its constants.
struct ForceOverflow {
  bool happened = false;
  int substep = 0, a = 0, b = 0;
  double stiffness = 0, rest = 0;
};

class Arena {
 public:
  virtual ~Arena() = default;
  /// Gives the records their places, fills and uploads; runs the start pass of cloths that have not
  /// moved, and surveys. `dt`: of the substep to come; `time`: of the world.
  virtual Status build(const ArenaInput&, double dt, double time, Workers) = 0;
  /// Copies the state of every moved cloth to its record.
  virtual Status save(const ArenaInput&) = 0;
  /// Advances and surveys: the records learn where their cloths are.
  virtual Status frame(const ArenaInput&, const FrameInput&) = 0;
  /// `dt`: of the substep that the start of cloths that have not moved belongs to.
  virtual Status accelerations(const ArenaInput&, double dt, double dt_before, Workers) = 0;
  /// The first substep of a frame that changes nothing; its colliders may be others of the same
  /// shapes.
  virtual Status probe(const ArenaInput&, const FrameInput&) = 0;
  /// What the last probe found, of one cloth in caller order.
  virtual Status read_probe(const ClothRecord&, Vector<Probed>& out) = 0;
  /// Looks at some springs of every cloth that is awake (StretchWatch).
  virtual Status watch_stretch(const ArenaInput&) = 0;
  virtual Status normals(const ArenaInput&, Workers) = 0;
  /// Of one cloth in caller order; positions are local. Accelerations and normals: after the call
  /// that makes them; both overwrite the other.
  virtual Status read(const ClothRecord&, StateArray, Vector<double3>& out) = 0;
  /// Writes vertices to host memory; normals after the call that makes them.
  virtual Status write(const ClothRecord&, const VertexTarget&, Workers) = 0;
  /// Particles stand where they were when it happened.
  virtual Status force_overflow(ForceOverflow&) = 0;
  /// Pairs that self-collision finds nearer than their distance now, ascending by cloth in order of
  /// creation and by vertex.
  virtual Status near_pairs(const ArenaInput&, bool with_excluded, Workers,
                            Vector<NearPair>&) = 0;
  /// Lists made so far, and pairs in the last.
  virtual void list_counts(uint64_t& lists, uint64_t& listed) const = 0;
  virtual uint64_t bytes() const = 0;
  /// Of them, those of the list.
  virtual uint64_t list_bytes() const = 0;
};

std::unique_ptr<Arena> make_arena(Precision, ContextState&);

}  // namespace weft::api
