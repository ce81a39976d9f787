// weft.h, call by call: pointers are checked, values are handed to the C++ interface.
#include <cstddef>
#include <cstdlib>
#include <new>

#include "api/c/c_types.h"

using namespace weft;  // NOLINT: this file is nothing but calls of it
using api::number;

/// An object of weft.h in the caller's memory, or none.
template <class Object, class... Values>
static Object* make_in(const weft_allocator& allocator, Values&&... values) {
  void* at = allocator.allocate
                 ? allocator.allocate(allocator.user, sizeof(Object), alignof(std::max_align_t))
                 : std::malloc(sizeof(Object));
  return at ? new (at) Object{static_cast<Values&&>(values)...} : nullptr;
}
template <class Object>
static void destroy_in(const weft_allocator& allocator, Object* object) {
  object->~Object();
  if (allocator.deallocate) return allocator.deallocate(allocator.user, object, sizeof(Object));
  std::free(object);
}

/// A new object of weft.h that holds what was made.
template <class Holder, class Made>
static weft_status hand_over(weft_context* owner, Result<Made> made, Holder** out) {
  if (!made) return number(made.status());
  Holder* holder = make_in<Holder>(owner->allocator, static_cast<Made&&>(*made), owner);
  if (!holder) return number(Status::out_of_memory);
  ++owner->references;
  owner->bytes += sizeof(Holder);
  *out = holder;
  return WEFT_OK;
}
template <class Holder>
static void take_back(Holder* holder) {
  if (!holder) return;
  weft_context* owner = holder->owner;
  destroy_in(owner->allocator, holder);
  owner->bytes -= sizeof(Holder);
  weft_context_release(owner);
}

const char* weft_status_text(weft_status status) { return to_string(static_cast<Status>(status)); }
const char* weft_build_info(void) { return build_info(); }

weft_context_desc weft_default_context(void) { return {}; }
weft_grid_desc weft_default_grid(void) {
  const GridDesc d;
  return {
      d.rows, d.columns, d.width, d.height, static_cast<uint8_t>(d.stencil), api::to_c(d.material)};
}
weft_mesh_desc weft_default_mesh(void) {
  return {{nullptr, 0, sizeof(float3), false}, {nullptr, 0, 4}, false, api::to_c(Material{}), 0,
          {nullptr, 0, sizeof(Spring)}};
}
weft_network_desc weft_default_network(void) {
  return {{nullptr, 0, sizeof(float3), false}, {nullptr, 0, sizeof(Spring)}, api::to_c(Material{})};
}
weft_collider_mesh_desc weft_default_collider_mesh(void) {
  const ColliderMeshDesc d;
  return {{nullptr, 0, sizeof(float3), false},
          {nullptr, 0, 4},
          d.scale,
          d.thickness,
          d.closed,
          d.weld_distance};
}
weft_world_desc weft_default_world(void) {
  const WorldDesc d;
  return {api::to_c(d.gravity),
          static_cast<uint8_t>(d.precision),
          static_cast<uint8_t>(d.form),
          static_cast<uint8_t>(d.start),
          static_cast<uint8_t>(d.integrator),
          {d.ladder[0], d.ladder[1], d.ladder[2], d.ladder[3], d.ladder[4], d.ladder[5]},
          d.substeps,
          d.max_substeps,
          d.safety,
          d.unsafe,
          d.fixed_dt,
          d.max_steps_per_advance,
          d.interpolate,
          static_cast<uint8_t>(d.evaluation),
          static_cast<uint8_t>(d.accumulate),
          d.deterministic,
          d.profile,
          d.fixed8_range};
}
weft_pose weft_default_pose(void) { return api::to_c(Pose{}); }
weft_cloth_desc weft_default_cloth(void) {
  const ClothDesc d;
  weft_cloth_desc out{};
  out.pose = weft_default_pose();
  out.positions = {nullptr, 0, sizeof(float3), false};
  out.velocities = {nullptr, 0, sizeof(double3)};
  out.pins = {nullptr, 0, sizeof(Pin)};
  out.motions = {nullptr, 0, sizeof(PinMotion)};
  out.forces = {nullptr, 0, sizeof(VertexForce)};
  out.settings = d;
  return out;
}
weft_sphere_desc weft_default_sphere(void) {
  const SphereDesc d;
  return {api::to_c(d.center), d.radius, api::to_c(d.velocity), d.friction, d.layers};
}
weft_plane_desc weft_default_plane(void) {
  const PlaneDesc d;
  return {api::to_c(d.normal), d.offset, api::to_c(d.velocity), d.friction, d.layers};
}
weft_capsule_desc weft_default_capsule(void) {
  const CapsuleDesc d;
  return {api::to_c(d.a), api::to_c(d.b), d.radius, api::to_c(d.velocity), d.friction, d.layers};
}
weft_cylinder_desc weft_default_cylinder(void) {
  const CylinderDesc d;
  return {api::to_c(d.a), api::to_c(d.b), d.radius, api::to_c(d.velocity), d.friction, d.layers};
}
weft_box_desc weft_default_box(void) {
  const BoxDesc d;
  return {api::to_c(d.center),   api::to_c(d.half), api::to_c(d.axis), d.degrees,
          api::to_c(d.velocity), d.friction,        d.layers};
}
weft_mesh_collider_desc weft_default_mesh_collider(void) {
  return {nullptr, weft_default_pose(), {0, 0, 0}, 0, MeshColliderDesc{}.layers};
}
weft_output_desc weft_default_output(void) { return {}; }
weft_wind_desc weft_default_wind(void) {
  const WindDesc d;
  return {api::to_c(d.velocity), d.air_density, d.normal, d.tangential};
}

weft_self_collision_desc weft_default_self_collision(void) {
  const SelfCollisionDesc d;
  return {static_cast<uint8_t>(d.search), d.distance, d.friction, d.cell, d.grids,
          static_cast<uint8_t>(d.shifts), d.window,   d.skin};
}

/// The log's severity is a number in C.
static void say_in_c(void* user, Severity severity, const char* text) {
  const auto* log = static_cast<const weft_log*>(user);
  log->message(log->user, static_cast<uint8_t>(severity), text);
}

weft_status weft_context_create(const weft_context_desc* desc, uint32_t abi, weft_context** out) {
  static_assert(WEFT_C_ABI == WEFT_ABI);
  if (!out) return WEFT_INVALID_ARGUMENT;
  weft_allocator memory{};
  if (desc && desc->allocator.allocate && desc->allocator.deallocate) memory = desc->allocator;
  auto* made = make_in<weft_context>(memory);
  if (!made) return number(Status::out_of_memory);
  made->allocator = memory;
  ContextDesc cpp = desc ? api::from_c(*desc) : ContextDesc{};
  if (desc && desc->log.message) {
    made->log = desc->log;
    cpp.log = {&made->log, say_in_c};
  }
  auto context = Context::create(cpp, abi);
  if (!context) {
    destroy_in(memory, made);
    return number(context.status());
  }
  made->context = static_cast<Context&&>(*context);
  *out = made;
  return WEFT_OK;
}
void weft_context_release(weft_context* c) {
  if (!c || --c->references > 0) return;
  const weft_allocator memory = c->allocator;
  destroy_in(memory, c);
}
weft_context_info weft_context_describe(const weft_context* c) {
  if (!c) return {"", "", "", 0, nullptr};
  const ContextInfo info = c->context.info();
  return {info.backend, info.device, info.isa, info.threads, info.fallback};
}
uint64_t weft_context_bytes(const weft_context* c) {
  return c ? c->context.bytes_allocated() + c->bytes : 0;
}

template <class Desc, class Holder>
static weft_status cook(weft_context* c, const Desc* desc, Holder** out) {
  if (!c) return WEFT_INVALID_HANDLE;
  if (!desc || !out) return WEFT_INVALID_ARGUMENT;
  return hand_over(c, c->context.cook(api::from_c(*desc)), out);
}
weft_status weft_cook_grid(weft_context* c, const weft_grid_desc* d, weft_fabric** out) {
  return cook(c, d, out);
}
weft_status weft_cook_mesh(weft_context* c, const weft_mesh_desc* d, weft_fabric** out) {
  return cook(c, d, out);
}
weft_status weft_cook_network(weft_context* c, const weft_network_desc* d, weft_fabric** out) {
  return cook(c, d, out);
}
weft_status weft_cook_collider_mesh(weft_context* c, const weft_collider_mesh_desc* d,
                                    weft_collider_mesh** out) {
  return cook(c, d, out);
}
void weft_fabric_release(weft_fabric* f) { take_back(f); }
uint32_t weft_fabric_vertices(const weft_fabric* f) { return f ? f->fabric.vertex_count() : 0; }
uint32_t weft_fabric_render_vertices(const weft_fabric* f) {
  return f ? f->fabric.render_vertex_count() : 0;
}
weft_status weft_fabric_read_particles(const weft_fabric* f, uint32_t* out) {
  return f ? number(f->fabric.read_particles(out)) : WEFT_INVALID_HANDLE;
}
uint64_t weft_fabric_springs(const weft_fabric* f) { return f ? f->fabric.spring_count() : 0; }
uint64_t weft_fabric_triangles(const weft_fabric* f) { return f ? f->fabric.triangle_count() : 0; }
weft_status weft_fabric_read_triangles(const weft_fabric* f, uint64_t first, uint64_t count,
                                       uint32_t* out) {
  return f ? number(f->fabric.read_triangles(first, count, out)) : WEFT_INVALID_HANDLE;
}
uint32_t weft_fabric_diagnostics(const weft_fabric* f) {
  return f ? f->fabric.diagnostics().count : 0;
}
weft_diagnostic weft_fabric_diagnostic(const weft_fabric* f, uint32_t index) {
  if (index >= weft_fabric_diagnostics(f)) return {};
  const Diagnostic& d = f->fabric.diagnostics()[index];
  return {static_cast<uint8_t>(d.severity), d.element, d.text};
}
uint32_t weft_collider_mesh_diagnostics(const weft_collider_mesh* m) {
  return m ? m->mesh.diagnostics().count : 0;
}
weft_diagnostic weft_collider_mesh_diagnostic(const weft_collider_mesh* m, uint32_t index) {
  if (index >= weft_collider_mesh_diagnostics(m)) return {};
  const Diagnostic& d = m->mesh.diagnostics()[index];
  return {static_cast<uint8_t>(d.severity), d.element, d.text};
}
void weft_collider_mesh_release(weft_collider_mesh* m) { take_back(m); }

weft_status weft_world_create(weft_context* c, const weft_world_desc* desc, weft_world** out) {
  if (!c) return WEFT_INVALID_HANDLE;
  if (!out) return WEFT_INVALID_ARGUMENT;
  return hand_over(c, c->context.create_world(desc ? api::from_c(*desc) : WorldDesc{}), out);
}
void weft_world_release(weft_world* w) { take_back(w); }
