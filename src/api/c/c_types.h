// From the structs of weft.h to those of the C++ interface, and back.
#pragma once

#include <atomic>

#include "weft/weft.h"
#include "weft/weft.hpp"

namespace weft::api {

static_assert(WEFT_IN_FLIGHT == int(Status::in_flight));
inline weft_status number(Status status) { return static_cast<weft_status>(status); }
inline double3 from_c(weft_double3 v) { return {v.x, v.y, v.z}; }
inline weft_double3 to_c(const double3& v) { return {v.x, v.y, v.z}; }
template <class T>
View<T> from_c(weft_view v) {
  return {v.data, v.count, v.stride};
}
inline PointView from_c(const weft_points& p) {
  if (p.is_double) return View<double3>{p.data, p.count, p.stride};
  return View<float3>{p.data, p.count, p.stride};
}
template <class IdType>
IdType id_from_c(weft_id id) {
  return {id.index, id.generation};
}
template <class IdType>
weft_id to_c(IdType id) {
  return {id.index, id.generation};
}
inline Pose from_c(const weft_pose& p) { return {from_c(p.axis), p.degrees, from_c(p.translate)}; }
inline weft_pose to_c(const Pose& p) { return {to_c(p.axis), p.degrees, to_c(p.translate)}; }

Material from_c(const weft_material&);
weft_material to_c(const Material&);
ContextDesc from_c(const weft_context_desc&);
GridDesc from_c(const weft_grid_desc&);
MeshDesc from_c(const weft_mesh_desc&);
NetworkDesc from_c(const weft_network_desc&);
ColliderMeshDesc from_c(const weft_collider_mesh_desc&);
WorldDesc from_c(const weft_world_desc&);
ClothDesc from_c(const weft_cloth_desc&);
SphereDesc from_c(const weft_sphere_desc&);
PlaneDesc from_c(const weft_plane_desc&);
template <class Desc>
Desc rod_from_c(const weft_capsule_desc& d) {
  return {from_c(d.a), from_c(d.b), d.radius, from_c(d.velocity), d.friction, d.layers};
}
BoxDesc from_c(const weft_box_desc&);
MeshColliderDesc from_c(const weft_mesh_collider_desc&);
WindDesc from_c(const weft_wind_desc&);
SelfCollisionDesc from_c(const weft_self_collision_desc&);
ColliderSetDesc from_c(const weft_collider_set_desc&);
OutputDesc from_c(const weft_output_desc&);

}  // namespace weft::api

// What the pointers of weft.h point to. A context lives as long as what it made, whose messages go
// to its log.
struct weft_context {
  weft::Context context;
  weft_log log{};              ///< the caller's: its severity is a number
  weft_allocator allocator{};  ///< the caller's, or none
  std::atomic<uint32_t> references{1};
  std::atomic<uint64_t> bytes{0};  ///< of the objects of weft.h that it owns
};
struct weft_fabric {
  weft::Fabric fabric;
  weft_context* owner;
};
struct weft_collider_mesh {
  weft::ColliderMesh mesh;
  weft_context* owner;
};
struct weft_world {
  weft::World world;
  weft_context* owner;
};
