// Mass, stiffness and rest length of a cloth.
#include "io/scene_parts.h"

#include <algorithm>

namespace weft::io {
namespace {

bool has_triangles(const Shape& shape) {
  if (const auto* grid = std::get_if<GridShape>(&shape)) return grid->rows > 1 && grid->columns > 1;
  const auto* mesh = std::get_if<MeshShape>(&shape);
  return mesh && !mesh->mesh->triangles.empty();
}

void read_masses(const Node& node, ClothScene& cloth) {
  cloth.mass_kind = Mass::Kind::per_vertex;
  const size_t count = node.array_size("an array of masses");
  const uint32_t vertices = vertex_count(cloth.shape);
  if (count != vertices) {
    node.fail(node.value_text() + " has the wrong length (the cloth has " +
              std::to_string(vertices) + " vertices) give one mass per vertex");
  }
  cloth.masses.reserve(count);
  for (size_t i = 0; i < count; ++i) cloth.masses.push_back(node[i].number(Sign::positive));
}

void read_mass(const Node& node, ClothScene& cloth) {
  const std::string kind = node.exactly_one({"mass", "density", "masses"});
  const Node value = node.at(kind.c_str(), "it");
  if (kind == "masses") return read_masses(value, cloth);
  cloth.mass = value.number(Sign::positive);
  if (kind == "mass") return;
  cloth.mass_kind = Mass::Kind::density;
  if (!has_triangles(cloth.shape)) {
    value.fail(value.value_text() +
               " is a mass per area (this cloth has no triangles) give "
               "\"mass\" or \"masses\"");
  }
}

// Which classes of springs the shape has: stretch, shear, bend.
struct SpringClasses {
  bool stretch, shear, bend;
};

SpringClasses spring_classes(const Shape& shape) {
  if (const auto* grid = std::get_if<GridShape>(&shape)) {
    if (grid->rows == 1 && grid->columns == 1) return {false, false, false};
    const bool twelve = grid->stencil == Stencil::seed12 || grid->stencil == Stencil::classic12;
    return {true, twelve || grid->stencil == Stencil::tri6, twelve};
  }
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return {true, false, mesh->bend};
  const auto& springs = std::get<NetworkShape>(shape).springs;
  const bool lacking = std::any_of(springs.begin(), springs.end(),
                                   [](const Spring& spring) { return spring.stiffness < 0; });
  return {lacking, false, false};
}

double read_class(const Node& node, const char* key, bool needed) {
  if (!needed && !node.find(key)) return 0;
  return node.at(key, "a stiffness >= 0: this cloth has such springs").number(Sign::not_negative);
}

void read_stiffness(const Node& node, ClothScene& cloth) {
  const SpringClasses classes = spring_classes(cloth.shape);
  const bool needed = classes.stretch;
  if (!needed && !node.find("stiffness")) return;
  const Node stiffness = node.at("stiffness", "a number >= 0, or stretch, shear and bend");
  if (!stiffness.is_object()) {
    cloth.stiffness = Stiffness(stiffness.number(Sign::not_negative));
    return;
  }
  stiffness.require_object({"stretch", "shear", "bend"});
  cloth.stiffness.stretch = read_class(stiffness, "stretch", classes.stretch);
  cloth.stiffness.shear = read_class(stiffness, "shear", classes.shear);
  cloth.stiffness.bend = read_class(stiffness, "bend", classes.bend);
}

}  // namespace

void read_material(const Node& node, ClothScene& cloth) {
  read_mass(node, cloth);
  read_stiffness(node, cloth);
  const auto key = node.find("rest_length");
  if (!key) return;
  if (key->is_string())
    cloth.rest_length = key->choice<double>({{"initial", initial_rest_length}});
  else
    cloth.rest_length = key->number(Sign::not_negative);
}

}  // namespace weft::io
