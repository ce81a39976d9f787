#include "io/build.h"

#include "io/error.h"
#include "io/scene_size.h"

#include <algorithm>
#include <cctype>
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
    return context.cook(MeshDesc{View<double3>(mesh.positions), mesh.triangles, shape->bend,
                                 material, shape->weld_distance, mesh.lines});
  }
  const auto& network = std::get<NetworkShape>(cloth.shape);
  return context.cook(NetworkDesc{View<double3>(network.positions), network.springs, material});
}

std::vector<uint32_t> particles_of(const Fabric& fabric) {
  std::vector<uint32_t> particles;
  if (fabric.render_vertex_count() == fabric.vertex_count()) return particles;
  particles.resize(fabric.render_vertex_count());
  (void)fabric.read_particles(particles.data());
  return particles;
}

/// From vertices of the file to particles. A particle has the velocity of its first vertex.
ClothScene welded(const ClothScene& scene, const std::vector<uint32_t>& particles, uint32_t count,
                  const std::string& path) {
  ClothScene cloth = scene;
  for (Pin& pin : cloth.pins) pin.vertex = particles[pin.vertex];
  std::stable_sort(cloth.pins.begin(), cloth.pins.end(),
                   [](const Pin& a, const Pin& b) { return a.vertex < b.vertex; });
  for (size_t i = 1; i < cloth.pins.size(); ++i) {
    const Pin &a = cloth.pins[i - 1], &b = cloth.pins[i];
    if (a.vertex != b.vertex || a.motion == b.motion) continue;
    throw InputError(path + ".pins: vertices that weld_distance makes particle " +
                     std::to_string(a.vertex) +
                     " are pinned with different motions (it can follow one) pin one of them");
  }
  const auto end = std::unique(cloth.pins.begin(), cloth.pins.end(),
                               [](const Pin& a, const Pin& b) { return a.vertex == b.vertex; });
  cloth.pins.erase(end, cloth.pins.end());
  for (VertexForce& force : cloth.forces) force.vertex = particles[force.vertex];
  if (cloth.velocities.empty()) return cloth;
  cloth.velocities.resize(count);
  for (size_t v = particles.size(); v-- > 0;) {
    cloth.velocities[particles[v]] = scene.velocities[v];
  }
  return cloth;
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
  desc.integrator = scene.solver.method == Method::xpbd ? Integrator::xpbd : Integrator::verlet;
  std::fill(std::begin(desc.ladder), std::end(desc.ladder), uint8_t(0));
  std::copy(scene.solver.ladder.begin(), scene.solver.ladder.end(), desc.ladder);
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
    return world_.create_mesh({*mesh, scene.pose, scene.velocity, scene.friction, scene.layers})
        .status();
  }

 private:
  // Cooking is slow and its result is large, so equal meshes are one.
  Result<ColliderMesh> cook(const MeshColliderScene& scene) {
    const auto [known, is_new] = cooked_.emplace(key_of(scene), made_.collider_meshes.size());
    if (!is_new) return made_.collider_meshes[known->second];
    auto mesh = made_.context.cook(
        ColliderMeshDesc{View<double3>(scene.mesh->positions), scene.mesh->triangles, scene.scale,
                         scene.thickness, scene.closed, scene.weld_distance});
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

/// With the faces of the file where a message names triangles.
void require(const RunningScene& made, Status status, const std::string& path, const Mesh* mesh) {
  if (status == Status::ok || !mesh) return made.require(status, path);
  throw CoreError(status, path + ": " + with_faces(made.log->last_error(status), *mesh));
}

void add_cloths(const Scene& scene, RunningScene& made) {
  for (size_t i = 0; i < scene.cloths.size(); ++i) {
    const std::string path = element_path(scene, "cloths", i);
    auto fabric = cook(made.context, scene.cloths[i]);
    const auto* shape = std::get_if<MeshShape>(&scene.cloths[i].shape);
    require(made, fabric.status(), path, shape ? shape->mesh.get() : nullptr);
    made.fabrics.push_back(*fabric);
    made.particles.push_back(particles_of(*fabric));
    const std::vector<uint32_t>& particles = made.particles.back();
    const ClothScene& given = scene.cloths[i];
    const auto cloth = particles.empty()
                           ? made.world.create_cloth(cloth_desc(given, *fabric))
                           : made.world.create_cloth(cloth_desc(
                                 welded(given, particles, fabric->vertex_count(), path), *fabric));
    made.require(cloth.status(), path);
    made.cloths.push_back(*cloth);
  }
}

void add_surroundings(const Scene& scene, RunningScene& made) {
  ColliderMaker maker(made);
  for (size_t i = 0; i < scene.colliders.size(); ++i) {
    const auto* mesh = std::get_if<MeshColliderScene>(&scene.colliders[i]);
    require(made, std::visit(maker, scene.colliders[i]), element_path(scene, "colliders", i),
            mesh ? mesh->mesh.get() : nullptr);
    if (made.mesh_colliders.size() < made.collider_meshes.size()) made.mesh_colliders.push_back(i);
  }
  if (scene.wind) made.require(made.world.set_wind(*scene.wind), scene.file + ": $.wind");
  if (!scene.self_collision) return;
  made.require(made.world.set_self_collision(self_collision_desc(*scene.self_collision)),
               scene.file + ": $.self_collision");
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

SelfCollisionDesc self_collision_desc(const SelfCollisionScene& scene) {
  SelfCollisionDesc desc;
  desc.search = scene.complete ? PairSearch::complete : PairSearch::staggered;
  desc.distance = scene.distance;
  desc.friction = scene.friction;
  desc.cell = scene.cell;
  desc.grids = scene.grids;
  desc.shifts = scene.diagonal ? GridShifts::diagonal : GridShifts::corner;
  desc.window = scene.window.value_or(0);
  desc.skin = scene.skin.value_or(-1);
  return desc;
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

size_t vertex_count(const RunningScene& made, size_t cloth) {
  const size_t welded = made.particles[cloth].size();
  return welded > 0 ? welded : made.fabrics[cloth].vertex_count();
}

// A particle's number is at most that of its vertices, so that none is overwritten before it is
// read.
void spread(const RunningScene& made, size_t cloth, double3* values) {
  const std::vector<uint32_t>& particles = made.particles[cloth];
  for (size_t v = particles.size(); v-- > 0;) values[v] = values[particles[v]];
}

std::string with_faces(const std::string& text, const Mesh& mesh) {
  constexpr std::string_view word = "triangle";
  if (mesh.faces.empty()) return text;
  std::string named;
  for (size_t at = 0; at < text.size();) {
    if (text.compare(at, word.size(), word) != 0) {
      named += text[at++];
      continue;
    }
    size_t end = at + word.size();
    end += end < text.size() && text[end] == 's';
    named.append(text, at, end - at);
    at = end;
    // "triangle 7", "triangles 7 and 9", "first are 7, 8 and 9" stand behind the word.
    for (std::string_view joint : {" ", " and "}) {
      if (text.compare(at, joint.size(), joint) != 0) break;
      const size_t digits = at + joint.size();
      size_t stop = digits;
      uint64_t number = 0;
      while (stop < text.size() && std::isdigit(static_cast<unsigned char>(text[stop]))) {
        number = number * 10 + uint64_t(text[stop++] - '0');
      }
      if (stop == digits || stop - digits > 10 || number >= mesh.faces.size()) break;
      named.append(text, at, stop - at);
      named += " (face " + std::to_string(mesh.faces[size_t(number)]) + " of the file, from 0)";
      at = stop;
    }
  }
  return named;
}

/// The triangles of one cloth, by vertices of the scene.
static void add_triangles(const Scene& scene, const RunningScene& made, size_t cloth,
                          SurfacePart& part, Surface& surface) {
  const auto first = uint32_t(part.first_vertex);
  uint32_t* out = nullptr;
  const auto make_room = [&](size_t count) {
    part.triangle_count = count;
    surface.triangles.resize(part.first_triangle + count);
    out = count > 0 ? surface.triangles[part.first_triangle].data() : nullptr;
  };
  if (made.particles[cloth].empty()) {
    make_room(size_t(made.fabrics[cloth].triangle_count()));
    if (out) {
      made.require(made.fabrics[cloth].read_triangles(0, part.triangle_count, out), scene.file);
    }
  } else {
    const Mesh& mesh = *std::get<MeshShape>(scene.cloths[cloth].shape).mesh;
    make_room(mesh.triangles.size() / 3);
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), out);
  }
  for (size_t k = 0; k < 3 * part.triangle_count; ++k) out[k] += first;
}

const std::vector<Spring>* lines_of(const Shape& shape) {
  if (const auto* network = std::get_if<NetworkShape>(&shape)) return &network->springs;
  const auto* mesh = std::get_if<MeshShape>(&shape);
  return mesh ? &mesh->mesh->lines : nullptr;
}

Surface make_surface(const Scene& scene, const RunningScene& made) {
  Surface surface;
  for (size_t i = 0; i < scene.cloths.size(); ++i) {
    SurfacePart part{scene.cloths[i].name,
                     surface.positions.size(),
                     vertex_count(made, i),
                     surface.triangles.size(),
                     0,
                     surface.edges.size(),
                     0};
    const auto first = uint32_t(part.first_vertex);
    surface.positions.resize(part.first_vertex + part.vertex_count);
    add_triangles(scene, made, i, part, surface);
    if (const std::vector<Spring>* lines = lines_of(scene.cloths[i].shape)) {
      for (const Spring& s : *lines) surface.edges.push_back({first + s.a, first + s.b});
      part.edge_count = lines->size();
    }
    surface.parts.push_back(part);
  }
  return surface;
}

}  // namespace weft::io
