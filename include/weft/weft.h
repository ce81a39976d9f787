/* The same interface for C, and for what speaks C: C#, Rust, Godot, Python. What a call does, its
 * units, ranges and errors stand at the C++ function of the same name (weft/world.hpp and the
 * headers it includes); what differs is said here.
 *
 * Descriptions are filled by weft_default_*(): set what differs. Objects are pointers, given back
 * by weft_*_release in any order; what lives in a world has an id, and an id of zeros is null.
 * Every call that can fail returns a weft_status and leaves what it points to alone when it fails.
 */
#ifndef WEFT_WEFT_H
#define WEFT_WEFT_H

#include "weft/types.h"

#if defined(WEFT_STATIC)
#  define WEFT_C_API
#elif defined(__GNUC__)
#  define WEFT_C_API __attribute__((visibility("default")))
#elif defined(WEFT_BUILDING)
#  define WEFT_C_API __declspec(dllexport)
#else
#  define WEFT_C_API __declspec(dllimport)
#endif

/* The number of the binary layout; equal to WEFT_ABI of weft/core.hpp. */
#define WEFT_C_ABI 0

#ifdef __cplusplus
extern "C" {
#endif

WEFT_C_API const char* weft_status_text(weft_status);
WEFT_C_API const char* weft_build_info(void);

WEFT_C_API weft_context_desc weft_default_context(void);
WEFT_C_API weft_grid_desc weft_default_grid(void);
WEFT_C_API weft_mesh_desc weft_default_mesh(void);
WEFT_C_API weft_network_desc weft_default_network(void);
WEFT_C_API weft_collider_mesh_desc weft_default_collider_mesh(void);
WEFT_C_API weft_world_desc weft_default_world(void);
WEFT_C_API weft_cloth_desc weft_default_cloth(void);
WEFT_C_API weft_sphere_desc weft_default_sphere(void);
WEFT_C_API weft_plane_desc weft_default_plane(void);
WEFT_C_API weft_capsule_desc weft_default_capsule(void);
WEFT_C_API weft_cylinder_desc weft_default_cylinder(void);
WEFT_C_API weft_box_desc weft_default_box(void);
WEFT_C_API weft_mesh_collider_desc weft_default_mesh_collider(void);
WEFT_C_API weft_pose weft_default_pose(void);
WEFT_C_API weft_output_desc weft_default_output(void);
WEFT_C_API weft_wind_desc weft_default_wind(void);
WEFT_C_API weft_self_collision_desc weft_default_self_collision(void);

/* `abi`: WEFT_C_ABI of the header that the caller was compiled with. A null `desc`: the defaults.
 */
WEFT_C_API weft_status weft_context_create(const weft_context_desc* desc, uint32_t abi,
                                           weft_context** out);
WEFT_C_API void weft_context_release(weft_context*);
WEFT_C_API weft_context_info weft_context_describe(const weft_context*);
WEFT_C_API uint64_t weft_context_bytes(const weft_context*);
WEFT_C_API weft_status weft_cook_grid(weft_context*, const weft_grid_desc*, weft_fabric** out);
WEFT_C_API weft_status weft_cook_mesh(weft_context*, const weft_mesh_desc*, weft_fabric** out);
WEFT_C_API weft_status weft_cook_network(weft_context*, const weft_network_desc*,
                                         weft_fabric** out);
WEFT_C_API weft_status weft_cook_collider_mesh(weft_context*, const weft_collider_mesh_desc*,
                                               weft_collider_mesh** out);
WEFT_C_API void weft_fabric_release(weft_fabric*);
WEFT_C_API uint32_t weft_fabric_vertices(const weft_fabric*);
WEFT_C_API uint32_t weft_fabric_render_vertices(const weft_fabric*);
WEFT_C_API weft_status weft_fabric_read_particles(const weft_fabric*, uint32_t* out);
WEFT_C_API uint64_t weft_fabric_springs(const weft_fabric*);
WEFT_C_API uint64_t weft_fabric_triangles(const weft_fabric*);
WEFT_C_API weft_status weft_fabric_read_triangles(const weft_fabric*, uint64_t first,
                                                  uint64_t count, uint32_t* out);
WEFT_C_API uint32_t weft_fabric_diagnostics(const weft_fabric*);
/* `index` below weft_fabric_diagnostics, else zeros. The text lives as long as the fabric. */
WEFT_C_API weft_diagnostic weft_fabric_diagnostic(const weft_fabric*, uint32_t index);
WEFT_C_API uint32_t weft_collider_mesh_diagnostics(const weft_collider_mesh*);
/* As weft_fabric_diagnostic. */
WEFT_C_API weft_diagnostic weft_collider_mesh_diagnostic(const weft_collider_mesh*, uint32_t index);
WEFT_C_API void weft_collider_mesh_release(weft_collider_mesh*);

WEFT_C_API weft_status weft_world_create(weft_context*, const weft_world_desc*, weft_world** out);
WEFT_C_API void weft_world_release(weft_world*);
WEFT_C_API weft_status weft_create_cloth(weft_world*, const weft_cloth_desc*, weft_cloth_id* out);
/* What a cloth asks for and does not get, as its pins are now. A text lives until the next call of
 * either with this cloth. */
WEFT_C_API weft_status weft_cloth_diagnostics(weft_world*, weft_cloth_id, uint32_t* count);
WEFT_C_API weft_status weft_cloth_diagnostic(weft_world*, weft_cloth_id, uint32_t index,
                                             weft_diagnostic* out);
WEFT_C_API weft_status weft_destroy_cloth(weft_world*, weft_cloth_id);
WEFT_C_API bool weft_cloth_is_valid(const weft_world*, weft_cloth_id);
WEFT_C_API weft_status weft_create_sphere(weft_world*, const weft_sphere_desc*,
                                          weft_collider_id* out);
WEFT_C_API weft_status weft_create_plane(weft_world*, const weft_plane_desc*,
                                         weft_collider_id* out);
WEFT_C_API weft_status weft_create_capsule(weft_world*, const weft_capsule_desc*,
                                           weft_collider_id* out);
WEFT_C_API weft_status weft_create_cylinder(weft_world*, const weft_cylinder_desc*,
                                            weft_collider_id* out);
WEFT_C_API weft_status weft_create_box(weft_world*, const weft_box_desc*, weft_collider_id* out);
WEFT_C_API weft_status weft_create_mesh(weft_world*, const weft_mesh_collider_desc*,
                                        weft_collider_id* out);
WEFT_C_API weft_status weft_destroy_collider(weft_world*, weft_collider_id);
WEFT_C_API weft_status weft_move_collider(weft_world*, weft_collider_id, const weft_pose*,
                                          uint8_t move);
WEFT_C_API weft_status weft_create_collider_set(weft_world*, const weft_collider_set_desc*,
                                                weft_collider_set_id* out);
WEFT_C_API weft_status weft_move_collider_set(weft_world*, weft_collider_set_id,
                                              const weft_collider_set_desc*, uint8_t move);
WEFT_C_API weft_status weft_destroy_collider_set(weft_world*, weft_collider_set_id);
WEFT_C_API weft_status weft_move_pins(weft_world*, weft_cloth_id, const uint32_t* vertices,
                                      uint32_t count, weft_points targets);
WEFT_C_API weft_status weft_set_skinned_targets(weft_world*, weft_cloth_id, weft_points targets);
WEFT_C_API weft_status weft_release_pins(weft_world*, weft_cloth_id, const uint32_t* vertices,
                                         uint32_t count);
WEFT_C_API weft_status weft_set_forces(weft_world*, weft_cloth_id, const weft_vertex_force* forces,
                                       uint32_t count);
WEFT_C_API weft_status weft_set_gravity(weft_world*, weft_double3);
WEFT_C_API weft_status weft_set_wind(weft_world*, const weft_wind_desc*);
WEFT_C_API weft_status weft_clear_wind(weft_world*);
WEFT_C_API weft_status weft_set_self_collision(weft_world*, const weft_self_collision_desc*);
WEFT_C_API weft_status weft_clear_self_collision(weft_world*);
WEFT_C_API weft_status weft_contacts(weft_world*, weft_contact_counts* out);
/* Up to `room` pairs; `out` may be null for none. `count`: how many there are. */
WEFT_C_API weft_status weft_near_pairs(weft_world*, bool with_excluded, weft_near_pair* out,
                                       uint32_t room, uint32_t* count);
WEFT_C_API weft_status weft_wake(weft_world*, weft_cloth_id);
WEFT_C_API weft_status weft_asleep(weft_world*, weft_cloth_id, bool* out);

WEFT_C_API weft_status weft_step(weft_world*, double dt);
WEFT_C_API weft_status weft_prepare(weft_world*, double dt);
WEFT_C_API weft_status weft_substeps(weft_world*, double dt, uint32_t* out);
WEFT_C_API weft_status weft_advance_frame(weft_world*, double frame_dt, weft_advance* out);
WEFT_C_API weft_status weft_begin_step(weft_world*, double dt);
WEFT_C_API bool weft_step_done(const weft_world*);
WEFT_C_API weft_status weft_end_step(weft_world*);

WEFT_C_API weft_status weft_bind_output(weft_world*, weft_cloth_id, const weft_output_desc*,
                                        weft_output_id* out);
WEFT_C_API weft_status weft_unbind_output(weft_world*, weft_output_id);
WEFT_C_API weft_status weft_set_output_memory(weft_world*, weft_output_id, void* memory,
                                              uint64_t bytes);
WEFT_C_API weft_status weft_write_outputs(weft_world*, double alpha);
WEFT_C_API weft_status weft_cloth_bounds(const weft_world*, weft_cloth_id, weft_bounds* out);
WEFT_C_API weft_status weft_cloth_stability(weft_world*, weft_cloth_id, weft_stability* out);
WEFT_C_API weft_stability weft_world_stability(weft_world*);
/* Up to `room` passes; `out` may be null for none. `count`: how many there are. */
WEFT_C_API weft_status weft_plan(weft_world*, weft_pass* out, uint32_t room, uint32_t* count);
WEFT_C_API weft_debug_draw weft_default_debug_draw(void);
WEFT_C_API weft_status weft_draw(weft_world*, const weft_debug_draw*);
WEFT_C_API uint32_t weft_event_count(const weft_world*);
/* Of the last step; `index` below weft_event_count, else zeros. The text is valid until the next.
 */
WEFT_C_API weft_event weft_event_at(const weft_world*, uint32_t index);
WEFT_C_API weft_stats weft_world_stats(const weft_world*);
WEFT_C_API double weft_time(const weft_world*);
WEFT_C_API weft_status weft_read_positions(weft_world*, weft_cloth_id, weft_double3* out,
                                           uint32_t stride);
WEFT_C_API weft_status weft_read_positions_float(weft_world*, weft_cloth_id, weft_float3* out,
                                                 uint32_t stride);
WEFT_C_API weft_status weft_read_velocities(weft_world*, weft_cloth_id, weft_double3* out);
WEFT_C_API weft_status weft_read_accelerations(weft_world*, weft_cloth_id, weft_double3* out);
WEFT_C_API weft_status weft_read_normals(weft_world*, weft_cloth_id, weft_double3* out,
                                         uint32_t stride);
WEFT_C_API weft_status weft_read_normals_float(weft_world*, weft_cloth_id, weft_float3* out,
                                               uint32_t stride);
WEFT_C_API weft_status weft_read_mechanics(weft_world*, weft_mechanics* out);
WEFT_C_API weft_status weft_state_hash(weft_world*, uint64_t* out);

#ifdef __cplusplus
}
#endif

#endif
