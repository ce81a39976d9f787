/* The C interface end to end: the program of consumer.cpp in C, and every kind of call once. */
#include "weft/weft.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int messages = 0;

static void on_message(void* user, uint8_t severity, const char* text) {
  (void)text;
  if (user == &messages && severity == WEFT_ERROR) ++messages;
}

static void must(weft_status status, const char* what) {
  if (status == WEFT_OK) return;
  fprintf(stderr, "%s: %s\n", what, weft_status_text(status));
  exit(1);
}
static void must_be(weft_status status, weft_status wanted, const char* what) {
  if (status == wanted) return;
  fprintf(stderr, "%s: %s instead of %s\n", what, weft_status_text(status),
          weft_status_text(wanted));
  exit(1);
}
static void hold(int condition, const char* what) {
  if (condition) return;
  fprintf(stderr, "%s\n", what);
  exit(1);
}

static weft_view view(const void* data, size_t count, size_t stride) {
  weft_view v = {data, (uint32_t)count, (uint32_t)stride};
  return v;
}

/* A cloth, a collider and 30 steps; the hash of the state, as consumer.cpp prints it. */
static uint64_t fall(weft_context* context) {
  weft_grid_desc grid = weft_default_grid();
  weft_fabric* fabric = NULL;
  weft_world* world = NULL;
  const weft_pin pins[] = {{0, WEFT_PIN_FIXED}, {19, WEFT_PIN_FIXED}};
  weft_cloth_desc cloth_desc = weft_default_cloth();
  weft_sphere_desc sphere = weft_default_sphere();
  weft_cloth_id cloth;
  weft_collider_id collider;
  weft_double3 positions[400];
  uint64_t hash = 0;
  int i;

  grid.rows = grid.columns = 20;
  must(weft_cook_grid(context, &grid, &fabric), "cook");
  hold(weft_fabric_vertices(fabric) == 400 && weft_fabric_triangles(fabric) == 722, "counts");
  must(weft_world_create(context, NULL, &world), "world");
  cloth_desc.fabric = fabric;
  cloth_desc.pins = view(pins, 2, sizeof pins[0]);
  must(weft_create_cloth(world, &cloth_desc, &cloth), "cloth");
  weft_fabric_release(fabric); /* the cloth keeps it */
  sphere.center.x = 0.5;
  sphere.center.y = -0.6;
  sphere.radius = 0.3;
  must(weft_create_sphere(world, &sphere, &collider), "sphere");
  for (i = 0; i < 30; ++i) must(weft_step(world, 1.0 / 60), "step");
  must(weft_read_positions(world, cloth, positions, sizeof positions[0]), "read");
  hold(positions[399].y < 0.9, "the sheet did not fall");
  must(weft_state_hash(world, &hash), "hash");
  weft_world_release(world);
  return hash;
}

static void count_line(void* user, weft_double3 a, weft_double3 b, uint32_t rgba) {
  (void)rgba;
  if (fabs(a.x) < 100 && fabs(b.x) < 100) ++*(int*)user;
}

static void outputs_and_time(weft_context* context) {
  weft_mesh_desc mesh = weft_default_mesh();
  weft_network_desc network = weft_default_network();
  weft_collider_mesh_desc ground = weft_default_collider_mesh();
  weft_world_desc world_desc = weft_default_world();
  weft_cloth_desc cloth_desc = weft_default_cloth();
  weft_mesh_collider_desc placed = weft_default_mesh_collider();
  weft_output_desc output = {{WEFT_FORMAT_F32X3, 0, 16},
                             {WEFT_FORMAT_OCT16X2, 12, 16},
                             {WEFT_FORMAT_NONE, 0, 0},
                             NULL,
                             0,
                             0,
                             {0, 0, 0}};
  const weft_double3 square[] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  const uint32_t triangles[] = {0, 2, 1, 0, 3, 2};
  const weft_spring springs[] = {{0, 1, -1, -1}, {1, 2, -1, -1}};
  const weft_spring brace = {1, 3, -1, -1};
  const weft_points points = {square, 4, sizeof square[0], true};
  const weft_vertex_force force = {2, {0, 0.1, 0}};
  const uint32_t first = 0;
  const weft_double3 target = {0, 0.5, 0};
  const weft_points targets = {&target, 1, sizeof target, true};
  unsigned char memory[64];
  weft_fabric *fabric = NULL, *net = NULL;
  weft_collider_mesh* collider_mesh = NULL;
  weft_world* world = NULL;
  weft_cloth_id cloth, chain;
  weft_collider_id colliders[6];
  weft_output_id bound;
  weft_capsule_desc capsule = weft_default_capsule();
  weft_cylinder_desc cylinder = weft_default_cylinder();
  weft_plane_desc plane = weft_default_plane();
  weft_box_desc box = weft_default_box();
  weft_wind_desc wind = weft_default_wind();
  weft_pose pose = weft_default_pose();
  weft_sphere_desc sphere = weft_default_sphere();
  weft_collider_set_desc set_desc;
  weft_collider_set_id set;
  weft_advance advance;
  weft_bounds bounds;
  weft_stability stability;
  weft_mechanics mechanics;
  weft_double3 out[4];
  weft_float3 near_out[4];
  weft_pass passes[2];
  weft_self_collision_desc self = weft_default_self_collision();
  weft_contact_counts contacts;
  weft_near_pair pairs[2];
  uint32_t pair_count = 9;
  weft_debug_draw draw = weft_default_debug_draw();
  uint32_t substeps = 0, pass_count = 0, particles[4];
  int lines = 0;
  bool asleep = true;
  float y = 0;
  int i;

  mesh.positions = network.positions = ground.positions = points;
  hold(!weft_default_mesh().positions.is_double &&
           weft_default_mesh().positions.stride == sizeof(weft_float3) &&
           weft_default_output().memory == NULL,
       "defaults");
  hold(weft_double_points(square, 4).stride == points.stride && WEFT_VIEW(square, 4).count == 4 &&
           !weft_float_points(NULL, 0).is_double &&
           weft_view_of(square, SIZE_MAX, 1).count == UINT32_MAX,
       "views");
  mesh.indices = ground.indices = WEFT_VIEW(triangles, 6);
  mesh.springs = view(&brace, 1, sizeof brace);
  ground.weld_distance = 1e-3;
  network.springs = view(springs, 2, sizeof springs[0]);
  must(weft_cook_mesh(context, &mesh, &fabric), "mesh");
  must(weft_cook_network(context, &network, &net), "network");
  must(weft_cook_collider_mesh(context, &ground, &collider_mesh), "collider mesh");
  world_desc.interpolate = true;
  world_desc.precision = WEFT_FLOAT64;
  must(weft_world_create(context, &world_desc, &world), "world");
  cloth_desc.fabric = fabric;
  cloth_desc.pose.translate.y = 2;
  must(weft_create_cloth(world, &cloth_desc, &cloth), "cloth");
  cloth_desc.fabric = net;
  must(weft_create_cloth(world, &cloth_desc, &chain), "network cloth");
  placed.mesh = collider_mesh;
  placed.pose.translate.y = -1;
  plane.offset = -2;
  capsule.a.y = capsule.b.y = cylinder.a.y = box.center.y = -9;
  cylinder.b.y = -8;
  must(weft_create_mesh(world, &placed, &colliders[0]), "mesh collider");
  must(weft_create_plane(world, &plane, &colliders[1]), "plane");
  must(weft_create_capsule(world, &capsule, &colliders[2]), "capsule");
  must(weft_create_cylinder(world, &cylinder, &colliders[3]), "cylinder");
  must(weft_create_box(world, &box, &colliders[4]), "box");
  pose.translate.y = -0.1;
  must(weft_move_collider(world, colliders[4], &pose, WEFT_MOVE_TELEPORT), "move");
  must(weft_destroy_collider(world, colliders[4]), "destroy collider");
  must_be(weft_destroy_collider(world, colliders[4]), WEFT_INVALID_HANDLE, "stale collider");
  sphere.center.y = -20;
  memset(&set_desc, 0, sizeof set_desc);
  set_desc.spheres = view(&sphere, 1, sizeof sphere);
  must(weft_create_collider_set(world, &set_desc, &set), "set");
  sphere.center.y = -21;
  must(weft_move_collider_set(world, set, &set_desc, WEFT_MOVE_SIMULATE), "move set");
  sphere.radius = 3;
  must_be(weft_move_collider_set(world, set, &set_desc, WEFT_MOVE_SIMULATE), WEFT_INVALID_ARGUMENT,
          "a set that grows");
  must(weft_destroy_collider_set(world, set), "destroy set");
  must(weft_set_skinned_targets(world, cloth, points), "skinned targets");
  must(weft_set_wind(world, &wind), "wind");
  must(weft_clear_wind(world), "clear wind");
  hold(plane.layers == UINT32_MAX && box.layers == UINT32_MAX && placed.layers == UINT32_MAX &&
           cloth_desc.settings.collision_layers == UINT32_MAX &&
           cloth_desc.settings.collides_itself == 1 && cloth_desc.settings.collides_others == 1,
       "all layers");
  must_be(weft_near_pairs(world, false, NULL, 0, &pair_count), WEFT_INVALID_ARGUMENT, "no search");
  must(weft_set_self_collision(world, &self), "self-collision");
  must(weft_contacts(world, &contacts), "contacts");
  hold(contacts.excluded == 0, "at rest nobody is that near");
  must(weft_near_pairs(world, false, pairs, 2, &pair_count), "near pairs");
  hold(
      contacts.touching == 4 && pair_count == 4 && pairs[1].vertex_a == 1 && pairs[1].vertex_b == 1,
      "the chain lies on the sheet");
  self.distance = 0;
  must_be(weft_set_self_collision(world, &self), WEFT_INVALID_ARGUMENT, "no distance");
  must(weft_clear_self_collision(world), "clear self-collision");
  must(weft_set_gravity(world, target), "gravity");
  must(weft_set_forces(world, cloth, &force, 1), "forces");
  must(weft_move_pins(world, cloth, &first, 1, targets), "move pins");
  must(weft_release_pins(world, cloth, &first, 1), "release pins");
  output.memory = memory;
  output.bytes = sizeof memory;
  must(weft_bind_output(world, cloth, &output, &bound), "output");
  must(weft_prepare(world, 1.0 / 60), "prepare");
  must(weft_substeps(world, 1.0 / 60, &substeps), "substeps");
  hold(substeps >= 1, "no substeps");
  must(weft_begin_step(world, 1.0 / 60), "begin");
  must_be(weft_step(world, 1.0 / 60), WEFT_IN_FLIGHT, "step in flight");
  while (!weft_step_done(world)) {
  }
  must(weft_end_step(world), "end");
  must(weft_advance_frame(world, 0.025, &advance), "advance");
  hold(advance.steps == 1 && fabs(advance.alpha - 0.5) < 1e-9, "advance");
  must(weft_write_outputs(world, advance.alpha), "write");
  memcpy(&y, memory + 16 * 2 + 4, sizeof y);
  must(weft_read_positions(world, cloth, out, sizeof out[0]), "positions");
  must(weft_read_positions_float(world, cloth, near_out, sizeof near_out[0]), "float positions");
  for (i = 0; i < 4; ++i) hold(fabs((double)near_out[i].y - out[i].y) < 1e-6, "float positions");
  must(weft_read_normals_float(world, cloth, near_out, sizeof near_out[0]), "float normals");
  hold(weft_world_stats(world).cpu_seconds > 0, "no CPU time");
  must(weft_cloth_bounds(world, cloth, &bounds), "bounds");
  hold(y >= (float)bounds.low.y && y <= (float)bounds.high.y, "the vertex is out of bounds");
  hold((double)y < out[2].y, "not between the steps: the sheet rises");
  must(weft_read_normals(world, cloth, out, sizeof out[0]), "normals");
  for (i = 0; i < 4; ++i) hold(fabs(fabs(out[i].y) - 1) < 0.1, "normals of a level sheet");
  must(weft_read_velocities(world, cloth, out), "velocities");
  must(weft_read_mechanics(world, &mechanics), "mechanics");
  hold(mechanics.kinetic > 0, "no kinetic energy");
  must(weft_cloth_stability(world, cloth, &stability), "stability");
  hold(stability.dt_bound > 0, "no bound");
  hold(weft_world_stability(world).dt_bound <= stability.dt_bound, "the world's bound");
  must(weft_read_accelerations(world, cloth, out), "accelerations");
  must(weft_plan(world, passes, 2, &pass_count), "plan");
  hold(pass_count > 2 && strlen(passes[1].kernel) > 0, "passes");
  draw.user = &lines;
  must_be(weft_draw(world, &draw), WEFT_INVALID_ARGUMENT, "nowhere to draw");
  draw.line = count_line;
  must(weft_draw(world, &draw), "draw");
  hold(lines > 30, "lines");
  hold(weft_fabric_springs(fabric) == 6, "five edges and the brace between them");
  hold(weft_collider_mesh_diagnostics(collider_mesh) == 0 &&
           weft_collider_mesh_diagnostic(collider_mesh, 0).text == NULL,
       "a collider mesh without remarks");
  hold(weft_fabric_render_vertices(fabric) == 4 && weft_fabric_diagnostics(fabric) == 0 &&
           weft_fabric_diagnostic(fabric, 0).text == NULL,
       "diagnostics");
  must(weft_fabric_read_particles(fabric, particles), "particles");
  hold(particles[3] == 3, "particles");
  must(weft_asleep(world, cloth, &asleep), "asleep");
  hold(!asleep && weft_event_count(world) == 0 && weft_event_at(world, 3).text == NULL, "events");
  must(weft_wake(world, cloth), "wake");
  must(weft_set_output_memory(world, bound, memory, sizeof memory), "memory");
  must_be(weft_set_output_memory(world, bound, memory, 9), WEFT_INVALID_ARGUMENT, "small memory");
  must(weft_unbind_output(world, bound), "unbind");
  hold(weft_world_stats(world).frames == 2 && weft_time(world) > 0.03, "stats");
  must(weft_destroy_cloth(world, chain), "destroy");
  hold(!weft_cloth_is_valid(world, chain) && weft_cloth_is_valid(world, cloth), "valid");
  weft_collider_mesh_release(collider_mesh);
  weft_fabric_release(net);
  weft_fabric_release(fabric);
  weft_world_release(world);
}

static void nulls(weft_context* context) {
  weft_world* world = NULL;
  weft_cloth_id cloth = {0, 0};
  weft_output_desc output;
  memset(&output, 0, sizeof output);
  must_be(weft_world_create(NULL, NULL, &world), WEFT_INVALID_HANDLE, "no context");
  must_be(weft_world_create(context, NULL, NULL), WEFT_INVALID_ARGUMENT, "no room");
  must_be(weft_step(NULL, 0.1), WEFT_INVALID_HANDLE, "no world");
  must(weft_world_create(context, NULL, &world), "world");
  must_be(weft_create_cloth(world, NULL, &cloth), WEFT_INVALID_ARGUMENT, "no description");
  must_be(weft_create_sphere(world, NULL, &cloth), WEFT_INVALID_ARGUMENT, "no sphere");
  must_be(weft_bind_output(world, cloth, &output, &cloth), WEFT_INVALID_HANDLE, "null cloth");
  must_be(weft_move_pins(world, cloth, NULL, 3, weft_default_mesh().positions), WEFT_INVALID_HANDLE,
          "null pins");
  weft_world_release(world);
  weft_world_release(NULL);
  weft_fabric_release(NULL);
  weft_collider_mesh_release(NULL);
  weft_context_release(NULL);
}

int main(void) {
  weft_context_desc desc = weft_default_context();
  weft_context* context = NULL;
  uint64_t hash;
  desc.threads = 1;
  desc.log.user = &messages;
  desc.log.message = on_message;
  must_be(weft_context_create(&desc, WEFT_C_ABI + 1, &context), WEFT_VERSION_MISMATCH, "ABI");
  hold(context == NULL && messages == 1, "a refused context");
  must(weft_context_create(&desc, WEFT_C_ABI, &context), "context");
  hold(strlen(weft_context_describe(context).backend) > 0, "no back end");
  hash = fall(context);
  outputs_and_time(context);
  nulls(context);
  hold(weft_context_bytes(context) == 0, "something was not given back");
  weft_context_release(context);
  printf("%016llx\n", (unsigned long long)hash);
  return 0;
}
