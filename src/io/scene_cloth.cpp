// One entry of "cloths": everything but its shape, material and pins.
#include "io/scene_parts.h"

namespace weft::io {
namespace {

void read_damping(const Node& node, ClothScene& cloth) {
  node.require_object({"drag", "spring", "drag_model"});
  if (const auto key = node.find("drag")) cloth.drag = key->number(Sign::not_negative);
  if (const auto key = node.find("spring")) cloth.spring_damping = key->number(Sign::not_negative);
  if (const auto key = node.find("drag_model")) {
    cloth.drag_model =
        key->choice<DragModel>({{"central", DragModel::central}, {"lagged", DragModel::lagged}});
  }
}

void read_velocity(const Node& node, ClothScene& cloth) {
  const auto each = node.find("velocities");
  if (const auto all = node.find("velocity")) {
    cloth.velocity = all->vector();
    if (each) each->fail("stands beside \"velocity\" (only one is allowed) remove one of the two");
  }
  if (!each) return;
  const size_t count = each->array_size("an array of velocities");
  const uint32_t vertices = vertex_count(cloth.shape);
  if (count != vertices) {
    each->fail(each->value_text() + " has the wrong length (the cloth has " +
               std::to_string(vertices) + " vertices) give one velocity per vertex");
  }
  cloth.velocities.reserve(count);
  for (size_t i = 0; i < count; ++i) cloth.velocities.push_back((*each)[i].vector());
}

void read_force(const Node& node, ClothScene& cloth) {
  node.require_object({"vertices", "force"});
  const double3 force = node.at("force", "a vector in newtons").vector();
  const Node vertices = node.at("vertices", "an array of vertex indices");
  const size_t count = vertices.array_size("an array of vertex indices");
  const uint32_t most = vertex_count(cloth.shape);
  for (size_t i = 0; i < count; ++i) {
    cloth.forces.push_back({vertices[i].index(most, "vertices"), force});
  }
}

void read_sleep(const Node& node, ClothScene& cloth) {
  if (node.is_null()) return;
  node.require_object({"speed", "time"});
  cloth.sleep_speed = node.at("speed", "a speed > 0 in m/s").number(Sign::positive);
  if (const auto key = node.find("time")) cloth.sleep_time = key->number(Sign::not_negative);
}

void read_tethers(const Node& node, ClothScene& cloth) {
  if (node.is_null()) return;
  node.require_object({"scale", "compliance"});
  cloth.tether_scale = 1;
  if (const auto key = node.find("scale")) cloth.tether_scale = key->number(Sign::positive);
  if (const auto key = node.find("compliance")) {
    cloth.tether_compliance = key->number(Sign::not_negative);
  }
}

void read_collision(const Node& node, ClothScene& cloth) {
  node.require_object({"distance", "itself", "others", "layers"});
  const auto distance = node.find("distance");
  if (distance && !distance->is_null()) cloth.collision_distance = distance->number(Sign::positive);
  if (const auto key = node.find("itself")) cloth.collides_itself = key->boolean();
  if (const auto key = node.find("others")) cloth.collides_others = key->boolean();
  if (const auto key = node.find("layers")) cloth.collision_layers = read_layers(*key);
}

}  // namespace

void read_transform(const Node& node, double& scale, Pose& pose) {
  node.require_object({"scale", "rotate", "translate"});
  if (const auto key = node.find("scale")) scale = key->number(Sign::positive);
  if (const auto key = node.find("rotate")) read_rotation(*key, pose.axis, pose.degrees);
  if (const auto key = node.find("translate")) pose.translate = key->vector();
}

void read_rotation(const Node& node, double3& axis, double& degrees) {
  node.require_object({"axis", "degrees"});
  if (const auto key = node.find("degrees")) degrees = key->number();
  const auto key = node.find("axis");
  if (!key) return;
  axis = key->vector();
  if (degrees != 0 && axis.x == 0 && axis.y == 0 && axis.z == 0) {
    key->fail("[0, 0, 0] has no direction (the rotation is about it) give another axis");
  }
}

ClothScene read_cloth(const Node& node, MeshCache& meshes) {
  node.require_object({"name", "grid", "mesh", "network", "transform", "mass", "density", "masses",
                       "stiffness", "rest_length", "damping", "pins", "velocity", "velocities",
                       "forces", "sleep", "tethers", "collision"});
  ClothScene cloth;
  const Node name = node.at("name", "a name");
  cloth.name = name.text();
  if (cloth.name.empty()) name.fail("\"\" is not a name (messages use it) give one");
  cloth.shape = read_shape(node, meshes);
  if (const auto key = node.find("transform")) read_transform(*key, cloth.scale, cloth.pose);
  read_material(node, cloth);
  if (const auto key = node.find("damping")) read_damping(*key, cloth);
  if (const auto key = node.find("pins")) read_pins(*key, cloth);
  read_velocity(node, cloth);
  if (const auto key = node.find("forces")) {
    const size_t count = key->array_size("an array of forces");
    for (size_t i = 0; i < count; ++i) read_force((*key)[i], cloth);
  }
  if (const auto key = node.find("sleep")) read_sleep(*key, cloth);
  if (const auto key = node.find("tethers")) read_tethers(*key, cloth);
  if (const auto key = node.find("collision")) read_collision(*key, cloth);
  return cloth;
}

}  // namespace weft::io
