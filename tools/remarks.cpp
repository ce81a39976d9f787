#include "remarks.h"

namespace weft::tools {

static void add(std::vector<Remark>& found, Remark about, View<Diagnostic> diagnostics,
                const io::Mesh* mesh) {
  for (uint32_t k = 0; k < diagnostics.count; ++k) {
    const Diagnostic& d = diagnostics[k];
    about.severity = d.severity;
    about.element = d.element;
    about.text = d.text ? d.text : "";
    if (mesh) about.text = io::with_faces(about.text, *mesh);
    found.push_back(about);
  }
}

static void add(std::vector<Remark>& found, Remark about, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    about.text = text;
    found.push_back(about);
  }
}

std::vector<Remark> remarks(const io::Scene& scene, io::RunningScene& made) {
  std::vector<Remark> found;
  for (size_t i = 0; i < scene.cloths.size(); ++i) {
    const Remark about{Severity::warning, i, std::nullopt, 0, ""};
    const auto* shape = std::get_if<io::MeshShape>(&scene.cloths[i].shape);
    if (shape) add(found, about, shape->mesh->warnings);
    add(found, about, made.fabrics[i].diagnostics(), shape ? shape->mesh.get() : nullptr);
    const auto of_cloth = made.world.diagnostics(made.cloths[i]);
    made.require(of_cloth.status(), scene.file);
    add(found, about, *of_cloth, nullptr);
  }
  for (size_t m = 0; m < made.collider_meshes.size(); ++m) {
    const size_t collider = made.mesh_colliders[m];
    const Remark about{Severity::warning, std::nullopt, collider, 0, ""};
    const io::Mesh& mesh = *std::get<io::MeshColliderScene>(scene.colliders[collider]).mesh;
    add(found, about, mesh.warnings);
    add(found, about, made.collider_meshes[m].diagnostics(), &mesh);
  }
  return found;
}

std::string subject(const io::Scene& scene, const Remark& remark) {
  if (remark.cloth) return "cloth '" + scene.cloths[*remark.cloth].name + "': ";
  if (remark.collider) return "$.colliders[" + std::to_string(*remark.collider) + "]: ";
  return "";
}

}  // namespace weft::tools
