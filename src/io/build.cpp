#include "io/build.h"

#include "io/scene_size.h"

#include <map>

namespace weft::io {
namespace {

Material material_of(const ClothScene& cloth) {
  Material material;
  material.stiffness = cloth.stiffness;
  material.rest_length = cloth.rest_length;
  material.mass = {cloth.mass_kind, cloth.mass, cloth.masses};
  material.scale = cloth.scale;
  return material;
}

Result<Fabric> cook(Context& context, const ClothScene& cloth) {
  const Material material = material_of(cloth);
  if (const auto* grid = std::get_if<GridShape>(&cloth.shape)) {
    return context.cook(
        GridDesc{grid->rows, grid->columns, grid->width, grid->height, grid->stencil, material});
  }
  if (const auto* shape = std::get_if<MeshShape>(&cloth.shape)) {
    const Mesh& mesh = *shape->mesh;
    return context.cook(
        MeshDesc{View<double3>(mesh.positions), mesh.triangles, shape->bend, material});
  }
  const auto& network = std::get<NetworkShape>(cloth.shape);
  return context.cook(NetworkDesc{View<double3>(network.positions), network.springs, material});
}

ClothDesc cloth_desc(const ClothScene& cloth, const Fabric& fabric) {
  ClothDesc desc;
  static_cast<ClothSettings&>(desc) = cloth;
  desc.fabric = fabric;
  desc.pose = cloth.pose;
  desc.velocity = cloth.velocity;
  desc.velocities = cloth.velocities;
  desc.pins = cloth.pins;
  desc.motions = cloth.motions;
  desc.forces = cloth.forces;
  return desc;
}

WorldDesc world_desc(const Scene& scene) {
  WorldDesc desc;
  desc.gravity = scene.gravity;
  desc.precision = scene.solver.precision;
  desc.form = scene.solver.form;
  desc.start = scene.solver.start;
  desc.substeps = scene.time.substeps;
  desc.max_substeps = scene.time.max_substeps;
  desc.safety = scene.solver.safety;
  desc.unsafe = scene.solver.unsafe;
  desc.evaluation = scene.solver.evaluation;
  desc.accumulate = scene.solver.accumulate;
  desc.deterministic = scene.solver.deterministic;
  return desc;
}

class ColliderMaker {
 public:
  explicit ColliderMaker(RunningScene& made) : made_(made), world_(made.world) {}

  Status operator()(const SphereDesc& d) { return world_.create_sphere(d).status(); }
  Status operator()(const PlaneDesc& d) { return world_.create_plane(d).status(); }
  Status operator()(const CylinderDesc& d) { return world_.create_cylinder(d).status(); }
  Status operator()(const CapsuleDesc& d) { return world_.create_capsule(d).status(); }
  Status operator()(const BoxDesc& d) { return world_.create_box(d).status(); }
  Status operator()(const MeshColliderScene& scene) {
    const auto mesh = cook(scene);
    if (!mesh) return mesh.status();
    return world_.create_mesh({*mesh, scene.pose, scene.velocity, scene.friction}).status();
  }

 private:
  // Cooking is slow and its result is large, so equal meshes are one.
  Result<ColliderMesh> cook(const MeshColliderScene& scene) {
    const auto [known, is_new] = cooked_.emplace(key_of(scene), made_.collider_meshes.size());
    if (!is_new) return made_.collider_meshes[known->second];
    auto mesh = made_.context.cook(ColliderMeshDesc{View<double3>(scene.mesh->positions),
                                                    scene.mesh->triangles, scene.scale,
                                                    scene.thickness, scene.closed});
    if (mesh) made_.collider_meshes.push_back(*mesh);
    return mesh;
  }

  RunningScene& made_;
  World& world_;
  std::map<MeshKey, size_t> cooked_;  ///< numbers of collider_meshes
};

std::string element_path(const Scene& scene, const char* key, size_t index) {
  return scene.file + ": $." + key + "[" + std::to_string(index) + "]";
}

void add_cloths(const Scene& scene, RunningScene& made) {
  for (size_t i = 0; i < scene.cloths.size(); ++i) {
    const std::string path = element_path(scene, "cloths", i);
    auto fabric = cook(made.context, scene.cloths[i]);
    made.require(fabric.status(), path);
    made.fabrics.push_back(*fabric);
    const auto cloth = made.world.create_cloth(cloth_desc(scene.cloths[i], *fabric));
    made.require(cloth.status(), path);
    made.cloths.push_back(*cloth);
  }
}

void add_surroundings(const Scene& scene, RunningScene& made) {
  ColliderMaker maker(made);
  for (size_t i = 0; i < scene.colliders.size(); ++i) {
    made.require(std::visit(maker, scene.colliders[i]), element_path(scene, "colliders", i));
  }
  if (scene.wind) made.require(made.world.set_wind(*scene.wind), scene.file + ": $.wind");
}

}  // namespace

size_t RunningScene::index_of(ClothId id) const {
  size_t index = 0;
  while (index < cloths.size() && cloths[index] != id) ++index;
  return index;
}

void RunningScene::require(Status status, const std::string& where) const {
  if (status != Status::ok) throw CoreError(status, where + ": " + log->last_error(status));
}

RunningScene build(const Scene& scene, ContextDesc desc) {
  require_buildable(scene);
  RunningScene made;
  made.log = std::make_unique<MessageLog>();
  desc.log = made.log->callback();
  auto context = Context::create(desc);
  made.require(context.status(), scene.file);
  made.context = std::move(*context);
  auto world = made.context.create_world(world_desc(scene));
  made.require(world.status(), scene.file);
  made.world = std::move(*world);
  add_cloths(scene, made);
  add_surroundings(scene, made);
  return made;
}

Surface make_surface(const Scene& scene, const RunningScene& made) {
  Surface surface;
  for (size_t i = 0; i < scene.cloths.size(); ++i) {
    const Fabric& fabric = made.fabrics[i];
    SurfacePart part{scene.cloths[i].name,
                     surface.positions.size(),
                     fabric.vertex_count(),
                     surface.triangles.size(),
                     size_t(fabric.triangle_count()),
                     surface.edges.size(),
                     0};
    const auto first = uint32_t(part.first_vertex);
    surface.positions.resize(part.first_vertex + part.vertex_count);
    surface.triangles.resize(part.first_triangle + part.triangle_count);
    if (part.triangle_count > 0) {
      uint32_t* out = surface.triangles[part.first_triangle].data();
      made.require(fabric.read_triangles(0, part.triangle_count, out), scene.file);
      for (size_t k = 0; k < 3 * part.triangle_count; ++k) out[k] += first;
    }
    if (const auto* network = std::get_if<NetworkShape>(&scene.cloths[i].shape)) {
      for (const Spring& s : network->springs) surface.edges.push_back({first + s.a, first + s.b});
      part.edge_count = network->springs.size();
    }
    surface.parts.push_back(part);
  }
  return surface;
}

}  // namespace weft::io
