// The keys "colliders", "wind" and "self_collision".
#include "io/scene_parts.h"

#include <string_view>

namespace weft::io {
namespace {

bool is_zero(double3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }
bool same_point(double3 a, double3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

double read_radius(const Node& node) {
  return node.at("radius", "a length > 0").number(Sign::positive);
}

SphereDesc read_sphere(const Node& node) {
  node.require_object({"center", "radius"});
  SphereDesc sphere;
  sphere.center = node.at("center", "a position").vector();
  sphere.radius = read_radius(node);
  return sphere;
}

PlaneDesc read_plane(const Node& node) {
  node.require_object({"normal", "offset"});
  PlaneDesc plane;
  const Node normal = node.at("normal", "a direction");
  plane.normal = normal.vector();
  if (is_zero(plane.normal)) {
    normal.fail("[0, 0, 0] has no direction (the free side lies along it) give another vector");
  }
  plane.offset = node.at("offset", "a length along the normal").number();
  return plane;
}

CylinderDesc read_cylinder(const Node& node) {
  node.require_object({"a", "b", "radius"});
  const Node b = node.at("b", "the other end");
  CylinderDesc cylinder;
  cylinder.a = node.at("a", "one end").vector();
  cylinder.b = b.vector();
  cylinder.radius = read_radius(node);
  if (same_point(cylinder.a, cylinder.b)) {
    b.fail("is equal to \"a\" (a cylinder has a length) give two different ends");
  }
  return cylinder;
}

CapsuleDesc read_capsule(const Node& node) {
  node.require_object({"a", "b", "radius"});
  CapsuleDesc capsule;
  capsule.a = node.at("a", "one end").vector();
  capsule.b = node.at("b", "the other end").vector();
  capsule.radius = read_radius(node);
  return capsule;
}

BoxDesc read_box(const Node& node) {
  node.require_object({"center", "half", "rotate"});
  BoxDesc box;
  box.center = node.at("center", "a position").vector();
  const Node half = node.at("half", "half the lengths of the edges");
  box.half = half.vector();
  for (size_t axis = 0; axis < 3; ++axis) half[axis].number(Sign::positive);
  if (const auto key = node.find("rotate")) read_rotation(*key, box.axis, box.degrees);
  return box;
}

MeshColliderScene read_mesh_collider(const Node& node, MeshCache& meshes) {
  node.require_object({"file", "transform", "thickness", "closed", "weld_distance"});
  MeshColliderScene mesh;
  if (const auto key = node.find("transform")) read_transform(*key, mesh.scale, mesh.pose);
  if (const auto key = node.find("thickness")) mesh.thickness = key->number(Sign::positive);
  if (const auto key = node.find("closed")) mesh.closed = key->boolean();
  if (const auto key = node.find("weld_distance")) {
    mesh.weld_distance = key->number(Sign::not_negative);
  }
  const Node file = node.at("file", "the path of an OBJ or PLY file");
  mesh.mesh = load_mesh(file, meshes);
  if (mesh.mesh->triangles.empty()) {
    file.fail(file.text() + ": has no faces (cloth collides with them) give a surface");
  }
  return mesh;
}

ColliderScene read_collider_shape(const Node& node, MeshCache& meshes) {
  const std::string_view kind =
      node.exactly_one({"sphere", "plane", "cylinder", "capsule", "box", "mesh"});
  const Node shape = node.at(kind.data(), "it");
  if (kind == "sphere") return read_sphere(shape);
  if (kind == "plane") return read_plane(shape);
  if (kind == "cylinder") return read_cylinder(shape);
  if (kind == "capsule") return read_capsule(shape);
  if (kind == "box") return read_box(shape);
  return read_mesh_collider(shape, meshes);
}

void read_grids(const Node& node, SelfCollisionScene& scene) {
  if (const auto key = node.find("shifts")) {
    scene.diagonal = key->choice<bool>({{"corner", false}, {"diagonal", true}});
  }
  const auto key = node.find("grids");
  if (!key) return;
  scene.grids = uint32_t(key->integer(1, 64, "one to 64 grids are searched"));
  const bool corner = scene.grids == 1 || scene.grids == 2 || scene.grids == 4 || scene.grids == 8;
  if (!scene.diagonal && !corner) {
    key->out_of_range("\"corner\" shifts come as 1, 2, 4 or 8", "give one of these");
  }
}

}  // namespace

uint32_t read_layers(const Node& node) {
  return uint32_t(node.integer(0, UINT32_MAX, "there are 32 layers, a bit for each"));
}

ColliderScene read_collider(const Node& node, MeshCache& meshes) {
  node.require_object(
      {"sphere", "plane", "cylinder", "capsule", "box", "mesh", "friction", "velocity", "layers"});
  ColliderScene collider = read_collider_shape(node, meshes);
  std::visit(
      [&](auto& desc) {
        if (const auto key = node.find("friction")) desc.friction = key->number(Sign::not_negative);
        if (const auto key = node.find("velocity")) desc.velocity = key->vector();
        if (const auto key = node.find("layers")) desc.layers = read_layers(*key);
      },
      collider);
  return collider;
}

std::optional<WindDesc> read_wind(const Node& node) {
  if (node.is_null()) return std::nullopt;
  node.require_object({"velocity", "air_density", "normal", "tangential"});
  WindDesc wind;
  wind.velocity = node.at("velocity", "a vector in m/s").vector();
  if (const auto key = node.find("air_density")) wind.air_density = key->number(Sign::not_negative);
  if (const auto key = node.find("normal")) wind.normal = key->number(Sign::not_negative);
  if (const auto key = node.find("tangential")) wind.tangential = key->number(Sign::not_negative);
  return wind;
}

std::optional<SelfCollisionScene> read_self_collision(const Node& node) {
  if (node.is_null()) return std::nullopt;
  node.require_object(
      {"method", "distance", "friction", "cell", "grids", "shifts", "window", "skin"});
  SelfCollisionScene scene;
  if (const auto key = node.find("method")) {
    scene.complete = key->choice<bool>({{"staggered", false}, {"complete", true}});
  }
  if (const auto key = node.find("distance")) scene.distance = key->number(Sign::positive);
  if (const auto key = node.find("friction")) scene.friction = key->number(Sign::not_negative);
  if (const auto key = node.find("cell")) scene.cell = key->number(Sign::positive);
  read_grids(node, scene);
  const auto window = node.find("window");
  if (window && !window->is_null()) {
    scene.window =
        uint32_t(window->integer(1, INT32_MAX, "a particle tests at least its neighbour"));
  }
  const auto skin = node.find("skin");
  if (skin && !skin->is_null()) scene.skin = skin->number(Sign::not_negative);
  return scene;
}

}  // namespace weft::io
