// The calls of weft.h on a world.
#include "api/c/c_types.h"

using namespace weft;  // NOLINT: this file is nothing but calls of it
using api::number;

/// Runs `call(world)` where there is a world, and every pointer it needs.
template <class Call, class... Needed>
static weft_status on(weft_world* w, Call call, const Needed*... needed) {
  if (!w) return WEFT_INVALID_HANDLE;
  if (((needed == nullptr) || ... || false)) return WEFT_INVALID_ARGUMENT;
  return number(call(w->world));
}
/// The same for a call that makes a value.
template <class Out, class Call, class Put, class... Needed>
static weft_status take(weft_world* w, Out* out, Call call, Put put, const Needed*... needed) {
  return on(
      w,
      [&](World& world) {
        auto made = call(world);
        if (made) put(*made, *out);
        return made.status();
      },
      out, needed...);
}
static constexpr auto put_id = [](auto id, weft_id& out) { out = api::to_c(id); };
static constexpr auto put_value = [](auto value, auto& out) { out = value; };

weft_status weft_create_cloth(weft_world* w, const weft_cloth_desc* d, weft_cloth_id* out) {
  return take(
      w, out, [&](World& world) { return world.create_cloth(api::from_c(*d)); }, put_id, d);
}
weft_status weft_cloth_diagnostics(weft_world* w, weft_cloth_id id, uint32_t* count) {
  return take(
      w, count, [&](World& world) { return world.diagnostics(api::id_from_c<ClothId>(id)); },
      [](const View<Diagnostic>& told, uint32_t& out) { out = told.count; });
}
weft_status weft_cloth_diagnostic(weft_world* w, weft_cloth_id id, uint32_t index,
                                  weft_diagnostic* out) {
  return on(
      w,
      [&](World& world) {
        const auto told = world.diagnostics(api::id_from_c<ClothId>(id));
        if (!told) return told.status();
        if (index >= told->count) return Status::invalid_argument;
        const Diagnostic& d = (*told)[index];
        *out = {static_cast<uint8_t>(d.severity), d.element, d.text};
        return Status::ok;
      },
      out);
}
weft_status weft_destroy_cloth(weft_world* w, weft_cloth_id id) {
  return on(w, [&](World& world) { return world.destroy_cloth(api::id_from_c<ClothId>(id)); });
}
bool weft_cloth_is_valid(const weft_world* w, weft_cloth_id id) {
  return w && w->world.valid(api::id_from_c<ClothId>(id));
}
weft_status weft_create_sphere(weft_world* w, const weft_sphere_desc* d, weft_collider_id* out) {
  return take(
      w, out, [&](World& world) { return world.create_sphere(api::from_c(*d)); }, put_id, d);
}
weft_status weft_create_plane(weft_world* w, const weft_plane_desc* d, weft_collider_id* out) {
  return take(
      w, out, [&](World& world) { return world.create_plane(api::from_c(*d)); }, put_id, d);
}
weft_status weft_create_capsule(weft_world* w, const weft_capsule_desc* d, weft_collider_id* out) {
  return take(
      w, out, [&](World& world) { return world.create_capsule(api::rod_from_c<CapsuleDesc>(*d)); },
      put_id, d);
}
weft_status weft_create_cylinder(weft_world* w, const weft_cylinder_desc* d,
                                 weft_collider_id* out) {
  return take(
      w, out,
      [&](World& world) { return world.create_cylinder(api::rod_from_c<CylinderDesc>(*d)); },
      put_id, d);
}
weft_status weft_create_box(weft_world* w, const weft_box_desc* d, weft_collider_id* out) {
  return take(
      w, out, [&](World& world) { return world.create_box(api::from_c(*d)); }, put_id, d);
}
weft_status weft_create_mesh(weft_world* w, const weft_mesh_collider_desc* d,
                             weft_collider_id* out) {
  return take(
      w, out, [&](World& world) { return world.create_mesh(api::from_c(*d)); }, put_id, d);
}
weft_status weft_destroy_collider(weft_world* w, weft_collider_id id) {
  return on(w,
            [&](World& world) { return world.destroy_collider(api::id_from_c<ColliderId>(id)); });
}
weft_status weft_move_collider(weft_world* w, weft_collider_id id, const weft_pose* pose,
                               uint8_t move) {
  return on(
      w,
      [&](World& world) {
        return world.move_collider(api::id_from_c<ColliderId>(id), api::from_c(*pose),
                                   static_cast<Move>(move));
      },
      pose);
}
weft_status weft_create_collider_set(weft_world* w, const weft_collider_set_desc* d,
                                     weft_collider_set_id* out) {
  return take(
      w, out, [&](World& world) { return world.create_collider_set(api::from_c(*d)); }, put_id, d);
}
weft_status weft_move_collider_set(weft_world* w, weft_collider_set_id id,
                                   const weft_collider_set_desc* d, uint8_t move) {
  return on(
      w,
      [&](World& world) {
        return world.move_collider_set(api::id_from_c<ColliderSetId>(id), api::from_c(*d),
                                       static_cast<Move>(move));
      },
      d);
}
weft_status weft_destroy_collider_set(weft_world* w, weft_collider_set_id id) {
  return on(w, [&](World& world) {
    return world.destroy_collider_set(api::id_from_c<ColliderSetId>(id));
  });
}
weft_status weft_set_skinned_targets(weft_world* w, weft_cloth_id id, weft_points targets) {
  return on(w, [&](World& world) {
    return world.set_skinned_targets(api::id_from_c<ClothId>(id), api::from_c(targets));
  });
}
weft_status weft_move_pins(weft_world* w, weft_cloth_id id, const uint32_t* vertices,
                           uint32_t count, weft_points targets) {
  return on(w, [&](World& world) {
    return world.move_pins(api::id_from_c<ClothId>(id), {vertices, count}, api::from_c(targets));
  });
}
weft_status weft_release_pins(weft_world* w, weft_cloth_id id, const uint32_t* vertices,
                              uint32_t count) {
  return on(w, [&](World& world) {
    return world.release_pins(api::id_from_c<ClothId>(id), {vertices, count});
  });
}
weft_status weft_set_forces(weft_world* w, weft_cloth_id id, const weft_vertex_force* forces,
                            uint32_t count) {
  return on(w, [&](World& world) {
    return world.set_forces(api::id_from_c<ClothId>(id), {forces, count, sizeof *forces});
  });
}
weft_status weft_set_gravity(weft_world* w, weft_double3 gravity) {
  return on(w, [&](World& world) { return world.set_gravity(api::from_c(gravity)); });
}
weft_status weft_set_wind(weft_world* w, const weft_wind_desc* d) {
  return on(
      w, [&](World& world) { return world.set_wind(api::from_c(*d)); }, d);
}
weft_status weft_clear_wind(weft_world* w) {
  return on(w, [](World& world) { return world.clear_wind(); });
}
weft_status weft_set_self_collision(weft_world* w, const weft_self_collision_desc* d) {
  return on(
      w, [&](World& world) { return world.set_self_collision(api::from_c(*d)); }, d);
}
weft_status weft_clear_self_collision(weft_world* w) {
  return on(w, [](World& world) { return world.clear_self_collision(); });
}
weft_status weft_contacts(weft_world* w, weft_contact_counts* out) {
  return take(
      w, out, [](World& world) { return world.contacts(); },
      [](const ContactCounts& c, weft_contact_counts& made) {
        made = {c.touching, c.excluded, c.listed, c.lists};
      });
}
weft_status weft_near_pairs(weft_world* w, bool with_excluded, weft_near_pair* out, uint32_t room,
                            uint32_t* count) {
  return take(
      w, count, [&](World& world) { return world.near_pairs(with_excluded); },
      [&](const View<NearPair>& pairs, uint32_t& number_of) {
        number_of = pairs.count;
        for (uint32_t i = 0; out && i < room && i < number_of; ++i) {
          const NearPair& p = pairs[i];
          out[i] = {api::to_c(p.cloth_a), api::to_c(p.cloth_b), p.vertex_a, p.vertex_b};
        }
      });
}
weft_status weft_wake(weft_world* w, weft_cloth_id id) {
  return on(w, [&](World& world) { return world.wake(api::id_from_c<ClothId>(id)); });
}
weft_status weft_asleep(weft_world* w, weft_cloth_id id, bool* out) {
  return take(
      w, out, [&](World& world) { return world.asleep(api::id_from_c<ClothId>(id)); }, put_value);
}

weft_status weft_step(weft_world* w, double dt) {
  return on(w, [&](World& world) { return world.step(dt); });
}
weft_status weft_prepare(weft_world* w, double dt) {
  return on(w, [&](World& world) { return world.prepare(dt); });
}
weft_status weft_substeps(weft_world* w, double dt, uint32_t* out) {
  return take(
      w, out, [&](World& world) { return world.substeps(dt); }, put_value);
}
weft_status weft_advance_frame(weft_world* w, double frame_dt, weft_advance* out) {
  return take(
      w, out, [&](World& world) { return world.advance(frame_dt); },
      [](const Advance& a, weft_advance& made) {
        made = {a.steps, a.alpha, a.time};
      });
}
weft_status weft_begin_step(weft_world* w, double dt) {
  return on(w, [&](World& world) { return world.begin_step(dt); });
}
bool weft_step_done(const weft_world* w) { return !w || w->world.step_done(); }
weft_status weft_end_step(weft_world* w) {
  return on(w, [](World& world) { return world.end_step(); });
}

weft_status weft_bind_output(weft_world* w, weft_cloth_id id, const weft_output_desc* d,
                             weft_output_id* out) {
  return take(
      w, out,
      [&](World& world) { return world.bind_output(api::id_from_c<ClothId>(id), api::from_c(*d)); },
      put_id, d);
}
weft_status weft_unbind_output(weft_world* w, weft_output_id id) {
  return on(w, [&](World& world) { return world.unbind_output(api::id_from_c<OutputId>(id)); });
}
weft_status weft_set_output_memory(weft_world* w, weft_output_id id, void* memory, uint64_t bytes) {
  return on(w, [&](World& world) {
    return world.set_output_memory(api::id_from_c<OutputId>(id), memory, bytes);
  });
}
weft_status weft_write_outputs(weft_world* w, double alpha) {
  return on(w, [&](World& world) { return world.write_outputs(alpha); });
}
weft_status weft_cloth_bounds(const weft_world* w, weft_cloth_id id, weft_bounds* out) {
  if (!w) return WEFT_INVALID_HANDLE;
  if (!out) return WEFT_INVALID_ARGUMENT;
  const auto b = w->world.bounds(api::id_from_c<ClothId>(id));
  if (b) *out = {api::to_c((*b).low), api::to_c((*b).high)};
  return number(b.status());
}
weft_status weft_cloth_stability(weft_world* w, weft_cloth_id id, weft_stability* out) {
  return take(
      w, out, [&](World& world) { return world.stability(api::id_from_c<ClothId>(id)); },
      [](const Stability& s, weft_stability& made) {
        made = {s.dt_bound, api::to_c(s.cloth), s.a, s.b};
      });
}
weft_stability weft_world_stability(weft_world* w) {
  if (!w) return {};
  const Stability s = w->world.stability();
  return {s.dt_bound, api::to_c(s.cloth), s.a, s.b};
}
weft_status weft_plan(weft_world* w, weft_pass* out, uint32_t room, uint32_t* count) {
  return take(
      w, count, [](World& world) { return world.plan(); },
      [&](const PlanInfo& plan, uint32_t& number_of) {
        number_of = plan.passes.count;
        for (uint32_t i = 0; out && i < room && i < number_of; ++i) {
          const PassInfo& p = plan.passes[i];
          out[i] = {p.stage, p.per, p.kernel, p.count, p.bytes_per_particle, p.flops_per_particle};
        }
      });
}
weft_debug_draw weft_default_debug_draw(void) {
  const DebugDraw d;
  return {nullptr, nullptr, d.what, d.full_strain};
}
weft_status weft_draw(weft_world* w, const weft_debug_draw* d) {
  return on(
      w,
      [&](World& world) {
        DebugDraw draw;
        draw.what = d->what;
        draw.full_strain = d->full_strain;
        draw.user = const_cast<weft_debug_draw*>(d);
        if (d->line) {
          draw.line = [](void* user, double3 a, double3 b, uint32_t rgba) {
            const auto* in_c = static_cast<const weft_debug_draw*>(user);
            in_c->line(in_c->user, api::to_c(a), api::to_c(b), rgba);
          };
        }
        return world.debug_draw(draw);
      },
      d);
}
uint32_t weft_event_count(const weft_world* w) { return w ? w->world.events().count : 0; }
weft_event weft_event_at(const weft_world* w, uint32_t index) {
  if (index >= weft_event_count(w)) return {};
  const Event& e = w->world.events()[index];
  return {static_cast<uint8_t>(e.type), api::to_c(e.cloth), e.vertex, e.time, e.text};
}
weft_stats weft_world_stats(const weft_world* w) {
  if (!w) return {};
  const Stats s = w->world.stats();
  return {s.particles,     s.springs, s.frames,      s.steps,        s.substeps_last,
          s.substeps_most, s.dt_last, s.dt_least,    s.step_seconds, s.cpu_seconds,
          s.time_dropped,  s.threads, s.bytes_state, s.bytes_total};
}
double weft_time(const weft_world* w) { return w ? w->world.time() : 0; }

static_assert(sizeof(double3) == sizeof(weft_double3));
weft_status weft_read_positions(weft_world* w, weft_cloth_id id, weft_double3* out,
                                uint32_t stride) {
  return on(w, [&](World& world) {
    return world.read_positions(api::id_from_c<ClothId>(id), reinterpret_cast<double3*>(out),
                                stride);
  });
}
static_assert(sizeof(float3) == sizeof(weft_float3));
weft_status weft_read_positions_float(weft_world* w, weft_cloth_id id, weft_float3* out,
                                      uint32_t stride) {
  return on(w, [&](World& world) {
    return world.read_positions(api::id_from_c<ClothId>(id), reinterpret_cast<float3*>(out),
                                stride);
  });
}
weft_status weft_read_velocities(weft_world* w, weft_cloth_id id, weft_double3* out) {
  return on(w, [&](World& world) {
    return world.read_velocities(api::id_from_c<ClothId>(id), reinterpret_cast<double3*>(out));
  });
}
weft_status weft_read_accelerations(weft_world* w, weft_cloth_id id, weft_double3* out) {
  return on(w, [&](World& world) {
    return world.read_accelerations(api::id_from_c<ClothId>(id), reinterpret_cast<double3*>(out));
  });
}
weft_status weft_read_normals(weft_world* w, weft_cloth_id id, weft_double3* out, uint32_t stride) {
  return on(w, [&](World& world) {
    return world.read_normals(api::id_from_c<ClothId>(id), reinterpret_cast<double3*>(out), stride);
  });
}
weft_status weft_read_normals_float(weft_world* w, weft_cloth_id id, weft_float3* out,
                                    uint32_t stride) {
  return on(w, [&](World& world) {
    return world.read_normals(api::id_from_c<ClothId>(id), reinterpret_cast<float3*>(out), stride);
  });
}
weft_status weft_read_mechanics(weft_world* w, weft_mechanics* out) {
  return take(
      w, out, [](World& world) { return world.mechanics(); },
      [](const Mechanics& m, weft_mechanics& made) {
        made = {m.kinetic, m.elastic, m.potential, api::to_c(m.momentum), m.stretch};
      });
}
weft_status weft_state_hash(weft_world* w, uint64_t* out) {
  return take(
      w, out, [](World& world) { return world.state_hash(); }, put_value);
}
