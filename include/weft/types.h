/* The types of weft.h: numbers with names, objects, ids, views and descriptions. */
#ifndef WEFT_TYPES_H
#define WEFT_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "weft/cloth_settings.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t weft_status;
enum {
  WEFT_OK = 0,
  WEFT_INVALID_ARGUMENT,
  WEFT_INVALID_HANDLE,
  WEFT_VERSION_MISMATCH,
  WEFT_OUT_OF_MEMORY,
  WEFT_NO_DEVICE,
  WEFT_DEVICE_LOST,
  WEFT_UNSUPPORTED,
  WEFT_UNSTABLE_STEP,
  WEFT_DIVERGED,
  WEFT_WRONG_THREAD,
  WEFT_IN_FLIGHT
};
enum { WEFT_BACKEND_AUTOMATIC, WEFT_BACKEND_OMP, WEFT_BACKEND_CUDA, WEFT_BACKEND_HIP };
enum { WEFT_FLOAT32, WEFT_FLOAT64 };
enum { WEFT_FORM_SUMMED, WEFT_FORM_POSITION };
enum { WEFT_START_TAYLOR, WEFT_START_LAGGED };
enum { WEFT_EVALUATION_AUTOMATIC, WEFT_EVALUATION_GATHER, WEFT_EVALUATION_SCATTER };
enum {
  WEFT_ACCUMULATE_NATIVE,
  WEFT_ACCUMULATE_ATOMIC,
  WEFT_ACCUMULATE_FIXED64,
  WEFT_ACCUMULATE_FLOAT16,
  WEFT_ACCUMULATE_FLOAT24,
  WEFT_ACCUMULATE_FLOAT24_ALL,
  WEFT_ACCUMULATE_FIXED8
};
enum { WEFT_MOVE_SIMULATE, WEFT_MOVE_TELEPORT };
enum { WEFT_STENCIL_SEED12, WEFT_STENCIL_CLASSIC12, WEFT_STENCIL_QUAD4, WEFT_STENCIL_TRI6 };
enum { WEFT_MASS_TOTAL, WEFT_MASS_DENSITY, WEFT_MASS_PER_VERTEX };
enum { WEFT_SEARCH_COMPLETE, WEFT_SEARCH_STAGGERED };
enum { WEFT_SHIFTS_CORNER, WEFT_SHIFTS_DIAGONAL };
enum { WEFT_INFO, WEFT_WARNING, WEFT_ERROR };
enum {
  WEFT_FORMAT_NONE,
  WEFT_FORMAT_F32X3,
  WEFT_FORMAT_F32X4,
  WEFT_FORMAT_F16X4,
  WEFT_FORMAT_SNORM8X4,
  WEFT_FORMAT_SNORM16X4,
  WEFT_FORMAT_OCT16X2
};
enum {
  WEFT_EVENT_NON_FINITE,
  WEFT_EVENT_BACKEND_FALLBACK,
  WEFT_EVENT_SLEPT,
  WEFT_EVENT_WOKE,
  WEFT_EVENT_TIME_DROPPED,
  WEFT_EVENT_FORCE_OVERFLOW,
  WEFT_EVENT_LARGE_STRETCH,
  WEFT_EVENT_ENERGY_GROWTH
};
#define WEFT_PIN_FIXED UINT32_MAX

typedef struct weft_context weft_context;
typedef struct weft_fabric weft_fabric;
typedef struct weft_collider_mesh weft_collider_mesh;
typedef struct weft_world weft_world;
typedef struct weft_id {
  uint32_t index, generation;
} weft_id;
typedef weft_id weft_cloth_id, weft_collider_id, weft_collider_set_id, weft_output_id;
typedef struct weft_float3 {
  float x, y, z;
} weft_float3;
typedef struct weft_double3 {
  double x, y, z;
} weft_double3;

/* `count` elements, `stride` bytes apart; count 0: nothing. Of what, the field says. WEFT_VIEW
 * makes one of an array, weft_float_points and weft_double_points one of points. */
typedef struct weft_view {
  const void* data;
  uint32_t count, stride;
} weft_view;
typedef struct weft_points {
  const void* data; /* weft_float3 or weft_double3 */
  uint32_t count, stride;
  bool is_double; /* false, float, in the defaults */
} weft_points;

/* 2^32 - 1 elements or more have the count 2^32 - 1, and every call refuses them. */
static inline uint32_t weft_count(size_t count) {
  return count < UINT32_MAX ? (uint32_t)count : UINT32_MAX;
}
static inline weft_view weft_view_of(const void* data, size_t count, size_t stride) {
  weft_view v;
  v.data = data;
  v.count = weft_count(count);
  v.stride = (uint32_t)stride;
  return v;
}
#define WEFT_VIEW(array, count) weft_view_of((array), (count), sizeof *(array))
static inline weft_points weft_float_points(const weft_float3* points, size_t count) {
  weft_points p;
  p.data = points;
  p.count = weft_count(count);
  p.stride = (uint32_t)sizeof(weft_float3);
  p.is_double = false;
  return p;
}
static inline weft_points weft_double_points(const weft_double3* points, size_t count) {
  weft_points p;
  p.data = points;
  p.count = weft_count(count);
  p.stride = (uint32_t)sizeof(weft_double3);
  p.is_double = true;
  return p;
}

typedef struct weft_allocator {
  void* user;
  void* (*allocate)(void* user, size_t bytes, size_t alignment);
  void (*deallocate)(void* user, void* memory, size_t bytes);
} weft_allocator;
typedef struct weft_log {
  void* user;
  void (*message)(void* user, uint8_t severity, const char* text);
} weft_log;
typedef struct weft_jobs {
  void* user;
  uint32_t workers;
  void (*parallel_for)(void* user, uint32_t count, uint32_t grain,
                       void (*fn)(void* context, uint32_t begin, uint32_t end), void* context,
                       const char* name);
  void (*launch)(void* user, void (*fn)(void* context), void* context, const char* name);
} weft_jobs;
typedef struct weft_profiler {
  void* user;
  void* (*zone_begin)(void* user, const char* name);
  void (*zone_end)(void* user, void* zone);
} weft_profiler;
typedef struct weft_context_desc {
  uint8_t backend, isa; /* isa: 0 automatic, 1 v2, 2 v3, 3 v4 */
  uint32_t threads;
  weft_allocator allocator;
  weft_log log;
  weft_jobs jobs;
  weft_profiler profiler;
} weft_context_desc;
typedef struct weft_context_info {
  const char *backend, *device, *isa;
  uint32_t threads;
  const char* fallback;
} weft_context_info;

typedef struct weft_material {
  double stretch, shear, bend; /* N/m */
  double rest_length;          /* m; below 0: as in the rest shape */
  uint8_t mass_kind;
  double mass;
  weft_view masses; /* double */
  double scale;
} weft_material;
typedef struct weft_grid_desc {
  uint32_t rows, columns;
  double width, height;
  uint8_t stencil;
  weft_material material;
} weft_grid_desc;
typedef struct weft_spring {
  uint32_t a, b;
  double stiffness, rest_length; /* below 0: the material's */
} weft_spring;
typedef struct weft_mesh_desc {
  weft_points positions;
  weft_view indices; /* uint32_t */
  bool bend;
  weft_material material;
  double weld_distance;
  weft_view springs; /* weft_spring, beside the edges */
} weft_mesh_desc;
typedef struct weft_network_desc {
  weft_points positions;
  weft_view springs; /* weft_spring */
  weft_material material;
} weft_network_desc;
typedef struct weft_collider_mesh_desc {
  weft_points positions;
  weft_view indices; /* uint32_t */
  double scale, thickness;
  bool closed;
  double weld_distance;
} weft_collider_mesh_desc;

typedef struct weft_world_desc {
  weft_double3 gravity;
  uint8_t precision, form, start, integrator;
  uint8_t ladder[6];
  uint32_t substeps, max_substeps;
  double safety;
  bool unsafe;
  double fixed_dt;
  uint32_t max_steps_per_advance;
  bool interpolate;
  uint8_t evaluation, accumulate;
  bool deterministic, profile;
  double fixed8_range;
} weft_world_desc;
typedef struct weft_pin_motion {
  weft_double3 velocity, amplitude;
  double omega;
} weft_pin_motion;
typedef struct weft_pin {
  uint32_t vertex, motion;
} weft_pin;
typedef struct weft_vertex_force {
  uint32_t vertex;
  weft_double3 force;
} weft_vertex_force;
typedef struct weft_pose {
  weft_double3 axis;
  double degrees;
  weft_double3 translate;
} weft_pose;
typedef struct weft_cloth_desc {
  const weft_fabric* fabric;
  weft_pose pose;
  weft_points positions;
  weft_double3 velocity;
  weft_view velocities; /* weft_double3 */
  weft_view pins;       /* weft_pin */
  weft_view motions;    /* weft_pin_motion */
  weft_view forces;     /* weft_vertex_force */
  weft_cloth_settings settings;
  uint64_t user_data;
} weft_cloth_desc;

typedef struct weft_sphere_desc {
  weft_double3 center;
  double radius;
  weft_double3 velocity;
  double friction;
  uint32_t layers;
} weft_sphere_desc;
typedef struct weft_plane_desc {
  weft_double3 normal;
  double offset;
  weft_double3 velocity;
  double friction;
  uint32_t layers;
} weft_plane_desc;
typedef struct weft_capsule_desc {
  weft_double3 a, b;
  double radius;
  weft_double3 velocity;
  double friction;
  uint32_t layers;
} weft_capsule_desc;
typedef weft_capsule_desc weft_cylinder_desc;
typedef struct weft_box_desc {
  weft_double3 center, half, axis;
  double degrees;
  weft_double3 velocity;
  double friction;
  uint32_t layers;
} weft_box_desc;
typedef struct weft_mesh_collider_desc {
  const weft_collider_mesh* mesh;
  weft_pose pose;
  weft_double3 velocity;
  double friction;
  uint32_t layers;
} weft_mesh_collider_desc;
typedef struct weft_collider_set_desc {
  weft_view spheres, planes, capsules, cylinders, boxes; /* of weft_sphere_desc, ... */
  bool may_stretch;
} weft_collider_set_desc;
typedef struct weft_wind_desc {
  weft_double3 velocity;
  double air_density, normal, tangential;
} weft_wind_desc;
typedef struct weft_self_collision_desc {
  uint8_t search;
  double distance, friction, cell;
  uint32_t grids;
  uint8_t shifts;
  uint32_t window;
  double skin;
} weft_self_collision_desc;
typedef struct weft_contact_counts {
  uint64_t touching, excluded, listed, lists;
} weft_contact_counts;
typedef struct weft_near_pair {
  weft_cloth_id cloth_a, cloth_b;
  uint32_t vertex_a, vertex_b;
} weft_near_pair;

typedef struct weft_attribute {
  uint8_t format;
  uint32_t offset, stride;
} weft_attribute;
typedef struct weft_output_desc {
  weft_attribute position, normal, last_position;
  void* memory;
  uint64_t bytes;
  uint32_t first_vertex;
  weft_double3 origin;
} weft_output_desc;
typedef struct weft_bounds {
  weft_double3 low, high;
} weft_bounds;
typedef struct weft_advance {
  uint32_t steps;
  double alpha, time;
} weft_advance;
typedef struct weft_stability {
  double dt_bound;
  weft_cloth_id cloth;
  uint32_t a, b;
} weft_stability;
typedef struct weft_event {
  uint8_t type;
  weft_cloth_id cloth;
  uint32_t vertex;
  double time;
  const char* text;
} weft_event;
typedef struct weft_diagnostic {
  uint8_t severity;
  uint32_t element;
  const char* text;
} weft_diagnostic;
typedef struct weft_pass {
  const char *stage, *per, *kernel;
  uint64_t count;
  double bytes_per_particle, flops_per_particle;
} weft_pass;
typedef struct weft_debug_draw {
  void* user;
  void (*line)(void* user, weft_double3 a, weft_double3 b, uint32_t rgba);
  uint32_t what; /* 1 springs, 2 pins, 4 colliders, 8 bounds */
  double full_strain;
} weft_debug_draw;
typedef struct weft_mechanics {
  double kinetic, elastic, potential;
  weft_double3 momentum;
  double stretch;
} weft_mechanics;
typedef struct weft_stats {
  uint64_t particles, springs, frames, steps;
  uint32_t substeps_last, substeps_most;
  double dt_last, dt_least, step_seconds, cpu_seconds, time_dropped;
  uint32_t threads;
  uint64_t bytes_state, bytes_total;
} weft_stats;

#ifdef __cplusplus
}
#endif

#endif
