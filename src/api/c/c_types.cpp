#include "api/c/c_types.h"

namespace weft::api {

// Values out of range must reach the checks of the C++ interface as they are.
template <class Enum>
static Enum choice(uint8_t value) {
  return static_cast<Enum>(value);
}

Material from_c(const weft_material& m) {
  Material out;
  out.stiffness = {m.stretch, m.shear, m.bend};
  out.rest_length = m.rest_length;
  out.mass.kind = choice<Mass::Kind>(m.mass_kind);
  out.mass.value = m.mass;
  out.mass.values = from_c<double>(m.masses);
  out.scale = m.scale;
  return out;
}
weft_material to_c(const Material& m) {
  return {m.stiffness.stretch,
          m.stiffness.shear,
          m.stiffness.bend,
          m.rest_length,
          static_cast<uint8_t>(m.mass.kind),
          m.mass.value,
          {nullptr, 0, sizeof(double)},
          m.scale};
}

ContextDesc from_c(const weft_context_desc& d) {
  ContextDesc out;
  out.backend = choice<BackendKind>(d.backend);
  out.isa = choice<Isa>(d.isa);
  out.threads = d.threads;
  out.allocator = {d.allocator.user, d.allocator.allocate, d.allocator.deallocate};
  out.jobs = {d.jobs.user, d.jobs.workers, d.jobs.parallel_for, d.jobs.launch};
  out.profiler = {d.profiler.user, d.profiler.zone_begin, d.profiler.zone_end};
  return out;
}

GridDesc from_c(const weft_grid_desc& d) {
  GridDesc out;
  out.rows = d.rows;
  out.columns = d.columns;
  out.width = d.width;
  out.height = d.height;
  out.stencil = choice<Stencil>(d.stencil);
  out.material = from_c(d.material);
  return out;
}
MeshDesc from_c(const weft_mesh_desc& d) {
  static_assert(sizeof(Spring) == sizeof(weft_spring));
  return {from_c(d.positions), from_c<uint32_t>(d.indices), d.bend, from_c(d.material),
          d.weld_distance,     from_c<Spring>(d.springs)};
}
NetworkDesc from_c(const weft_network_desc& d) {
  return {from_c(d.positions), from_c<Spring>(d.springs), from_c(d.material)};
}
ColliderMeshDesc from_c(const weft_collider_mesh_desc& d) {
  return {from_c(d.positions), from_c<uint32_t>(d.indices), d.scale, d.thickness, d.closed,
          d.weld_distance};
}

WorldDesc from_c(const weft_world_desc& d) {
  WorldDesc out;
  out.gravity = from_c(d.gravity);
  out.precision = choice<Precision>(d.precision);
  out.form = choice<Form>(d.form);
  out.start = choice<Start>(d.start);
  out.integrator = choice<Integrator>(d.integrator);
  static_assert(sizeof out.ladder == sizeof d.ladder);
  std::copy(std::begin(d.ladder), std::end(d.ladder), out.ladder);
  out.substeps = d.substeps;
  out.max_substeps = d.max_substeps;
  out.safety = d.safety;
  out.unsafe = d.unsafe;
  out.fixed_dt = d.fixed_dt;
  out.max_steps_per_advance = d.max_steps_per_advance;
  out.interpolate = d.interpolate;
  out.evaluation = choice<Evaluation>(d.evaluation);
  out.accumulate = choice<Accumulate>(d.accumulate);
  out.deterministic = d.deterministic;
  out.profile = d.profile;
  out.fixed8_range = d.fixed8_range;
  return out;
}

ClothDesc from_c(const weft_cloth_desc& d) {
  static_assert(sizeof(Pin) == sizeof(weft_pin) && sizeof(PinMotion) == sizeof(weft_pin_motion) &&
                sizeof(VertexForce) == sizeof(weft_vertex_force));
  ClothDesc out;
  if (d.fabric) out.fabric = d.fabric->fabric;
  out.pose = from_c(d.pose);
  out.positions = from_c(d.positions);
  out.velocity = from_c(d.velocity);
  out.velocities = from_c<double3>(d.velocities);
  out.pins = from_c<Pin>(d.pins);
  out.motions = from_c<PinMotion>(d.motions);
  out.forces = from_c<VertexForce>(d.forces);
  static_cast<weft_cloth_settings&>(out) = d.settings;
  out.user_data = d.user_data;
  return out;
}

SphereDesc from_c(const weft_sphere_desc& d) {
  return {from_c(d.center), d.radius, from_c(d.velocity), d.friction, d.layers};
}
PlaneDesc from_c(const weft_plane_desc& d) {
  return {from_c(d.normal), d.offset, from_c(d.velocity), d.friction, d.layers};
}
BoxDesc from_c(const weft_box_desc& d) {
  return {from_c(d.center),   from_c(d.half), from_c(d.axis), d.degrees,
          from_c(d.velocity), d.friction,     d.layers};
}
MeshColliderDesc from_c(const weft_mesh_collider_desc& d) {
  return {d.mesh ? d.mesh->mesh : ColliderMesh(), from_c(d.pose), from_c(d.velocity), d.friction,
          d.layers};
}
WindDesc from_c(const weft_wind_desc& d) {
  return {from_c(d.velocity), d.air_density, d.normal, d.tangential};
}
SelfCollisionDesc from_c(const weft_self_collision_desc& d) {
  return {choice<PairSearch>(d.search), d.distance, d.friction, d.cell, d.grids,
          choice<GridShifts>(d.shifts), d.window,   d.skin};
}

ColliderSetDesc from_c(const weft_collider_set_desc& d) {
  static_assert(sizeof(SphereDesc) == sizeof(weft_sphere_desc) &&
                sizeof(PlaneDesc) == sizeof(weft_plane_desc) &&
                sizeof(CapsuleDesc) == sizeof(weft_capsule_desc) &&
                sizeof(CylinderDesc) == sizeof(weft_cylinder_desc) &&
                sizeof(BoxDesc) == sizeof(weft_box_desc));
  return {from_c<SphereDesc>(d.spheres),   from_c<PlaneDesc>(d.planes),
          from_c<CapsuleDesc>(d.capsules), from_c<CylinderDesc>(d.cylinders),
          from_c<BoxDesc>(d.boxes),        d.may_stretch};
}

OutputDesc from_c(const weft_output_desc& d) {
  const auto attribute = [](const weft_attribute& a) {
    return Attribute{choice<Format>(a.format), a.offset, a.stride};
  };
  OutputDesc out;
  out.layout = {attribute(d.position), attribute(d.normal), attribute(d.last_position)};
  out.memory = d.memory;
  out.bytes = d.bytes;
  out.first_vertex = d.first_vertex;
  out.origin = from_c(d.origin);
  return out;
}

}  // namespace weft::api
