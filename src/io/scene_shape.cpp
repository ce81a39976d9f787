// The keys "grid", "mesh" and "network" of a cloth.
#include "io/scene_parts.h"

#include "io/error.h"

#include <algorithm>
#include <filesystem>

namespace weft::io {
namespace {

constexpr int64_t most_vertices = int64_t(1) << 30;

GridShape read_grid(const Node& node) {
  node.require_object({"rows", "columns", "width", "height", "stencil"});
  GridShape grid;
  constexpr const char* why = "a grid has 1 to 2^30 vertices";
  grid.rows = uint32_t(node.at("rows", "an integer >= 1").integer(1, most_vertices, why));
  const Node columns = node.at("columns", "an integer >= 1");
  grid.columns = uint32_t(columns.integer(1, most_vertices, why));
  if (int64_t(grid.rows) * int64_t(grid.columns) > most_vertices) {
    columns.out_of_range("with " + std::to_string(grid.rows) +
                             " rows there are more than 2^30 "
                             "vertices",
                         "give fewer");
  }
  grid.width = node.at("width", "a length > 0").number(Sign::positive);
  grid.height = node.at("height", "a length > 0").number(Sign::positive);
  grid.stencil = node.at("stencil", "\"seed12\", \"classic12\", \"quad4\" or \"tri6\"")
                     .choice<Stencil>({{"seed12", Stencil::seed12},
                                       {"classic12", Stencil::classic12},
                                       {"quad4", Stencil::quad4},
                                       {"tri6", Stencil::tri6}});
  return grid;
}

}  // namespace

std::shared_ptr<const Mesh> load_mesh(const Node& file, MeshCache& cache) {
  const std::string& name = file.text();
  if (name.empty()) file.fail("\"\" names no file (a mesh is read from one) give its path");
  constexpr size_t longest = 1000;
  const bool odd = std::any_of(name.begin(), name.end(),
                               [](char c) { return static_cast<unsigned char>(c) < ' '; });
  if (odd || name.size() > longest) {
    file.fail(file.value_text() +
              " is no path that is read (it has control characters, or more than 1000 bytes) "
              "rename the file");
  }
  const auto given = std::filesystem::path(cache.folder) / name;
  std::error_code failure;
  const auto found = std::filesystem::canonical(given, failure);
  const std::string path = (failure ? given : found).string();
  auto& mesh = cache.meshes[path];
  if (mesh) return mesh;
  try {
    mesh = std::make_shared<const Mesh>(read_mesh(
        given.string(), largest_mesh_memory() - std::min(cache.bytes, largest_mesh_memory())));
  } catch (const InputError& error) {
    file.fail(error.what());
  }
  cache.bytes += mesh->positions.size() * sizeof(double3) + mesh->lines.size() * sizeof(Spring) +
                 (mesh->triangles.size() + mesh->faces.size()) * sizeof(uint32_t);
  if (mesh->positions.size() > uint64_t(most_vertices)) {
    file.fail(path + ": has more than 2^30 vertices (indices end there) give a smaller mesh");
  }
  return mesh;
}

namespace {

MeshShape read_mesh_shape(const Node& node, MeshCache& cache) {
  node.require_object({"file", "bend", "weld_distance"});
  MeshShape shape;
  if (const auto bend = node.find("bend")) shape.bend = bend->boolean();
  if (const auto key = node.find("weld_distance")) {
    shape.weld_distance = key->number(Sign::not_negative);
  }
  const Node file = node.at("file", "the path of an OBJ or PLY file");
  shape.mesh = load_mesh(file, cache);
  if (shape.mesh->triangles.empty() && shape.mesh->lines.empty()) {
    file.fail(file.text() +
              ": has no faces and no lines (a cloth's springs come from them) give a surface, or a "
              "network");
  }
  return shape;
}

Spring read_spring(const Node& node, size_t vertices) {
  const size_t length =
      node.array_size("[i, j], [i, j, stiffness] or [i, j, stiffness, rest_length]");
  if (length < 2 || length > 4) {
    node.fail(node.value_text() +
              " is not a spring (it has two ends, at most a stiffness and a rest "
              "length) give [i, j], [i, j, stiffness] or [i, j, stiffness, rest_length]");
  }
  Spring spring;
  spring.a = node[0].index(vertices, "vertices");
  spring.b = node[1].index(vertices, "vertices");
  if (spring.a == spring.b) {
    node.fail("[" + std::to_string(spring.a) + ", " + std::to_string(spring.b) +
              "] joins a vertex to itself (a spring has two ends) give two different vertices");
  }
  if (length > 2) spring.stiffness = node[2].number(Sign::not_negative);
  if (length > 3) spring.rest_length = node[3].number(Sign::not_negative);
  return spring;
}

NetworkShape read_network(const Node& node) {
  node.require_object({"positions", "springs"});
  NetworkShape network;
  const Node positions = node.at("positions", "an array of positions");
  const size_t vertices = positions.array_size("an array of positions");
  if (vertices == 0) positions.fail("is empty (a network needs at least one vertex) add one");
  network.positions.reserve(vertices);
  for (size_t i = 0; i < vertices; ++i) network.positions.push_back(positions[i].vector());
  const Node springs = node.at("springs", "an array of springs, which may be empty");
  const size_t count = springs.array_size("an array of springs");
  network.springs.reserve(count);
  for (size_t i = 0; i < count; ++i) network.springs.push_back(read_spring(springs[i], vertices));
  return network;
}

}  // namespace

Shape read_shape(const Node& cloth, MeshCache& cache) {
  const std::string kind = cloth.exactly_one({"grid", "mesh", "network"});
  const Node node = cloth.at(kind.c_str(), "it");
  if (kind == "grid") return read_grid(node);
  if (kind == "mesh") return read_mesh_shape(node, cache);
  return read_network(node);
}

}  // namespace weft::io
