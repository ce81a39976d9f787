#include "render/solid_models.h"

#include <Eigen/LU>

namespace weft::render {

static const Vector3f collider_colour{0.62f, 0.60f, 0.57f};

CapsuleModels::CapsuleModels(uint32_t corners) : form_(capsule_form(corners)) {
  glBindVertexArray(form_.array().name());
  constexpr size_t stride = sizeof(std::array<float, 7>);
  attribute(4, instances_, 3, stride, 0, true);
  attribute(5, instances_, 3, stride, 3 * sizeof(float), true);
  attribute(6, instances_, 1, stride, 6 * sizeof(float), true);
}

void CapsuleModels::fill(const std::vector<std::array<float, 7>>& capsules) {
  count_ = capsules.size();
  render::fill(instances_, GL_ARRAY_BUFFER, capsules.data(), count_ * sizeof capsules[0],
               GL_STREAM_DRAW);
}

void CapsuleModels::draw() const {
  if (count_ > 0) form_.draw_instances(count_);
}

SolidModels::SolidModels(const Solids& solids, const io::Scene& scene) : solids_(solids) {
  for (const Triangles& mesh : solids_.meshes) meshes_.emplace_back(mesh);
  solids_.meshes.clear();
  YieldingMesh::Shapes shapes;
  for (const size_t i : solids_.collider_meshes) {
    collider_meshes_.emplace_back(std::get<io::MeshColliderScene>(scene.colliders[i]), shapes);
  }
}

std::vector<std::string> SolidModels::problems() const {
  std::vector<std::string> lines;
  for (size_t i = 0; i < collider_meshes_.size(); ++i) {
    if (!collider_meshes_[i].shows()) continue;
    lines.push_back("$.colliders[" + std::to_string(solids_.collider_meshes[i]) +
                    "].mesh: shows through cloth (its edges go between the particles) give it more "
                    "\"thickness\", or the cloth more vertices");
  }
  return lines;
}

void SolidModels::update(const io::Surface& surface, double time, const Vector3d& origin) {
  for (YieldingMesh& mesh : collider_meshes_) mesh.update(surface, time);
  std::vector<std::array<float, 7>> capsules;
  for (const Capsule& c : solids_.capsules) {
    const Vector3d moved = c.velocity * time - origin;
    const Vector3f a = (c.a + moved).cast<float>(), b = (c.b + moved).cast<float>();
    capsules.push_back({a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), float(c.radius)});
  }
  capsules_.fill(capsules);
  places_.clear();
  for (const Solid& solid : solids_.solids) {
    Eigen::Matrix4f place = Eigen::Matrix4f::Identity();
    place.block<3, 3>(0, 0) = solid.axes.cast<float>();
    place.block<3, 1>(0, 3) = (solid.center + solid.velocity * time - origin).cast<float>();
    places_.push_back(place);
  }
}

void SolidModels::draw_solids(const Program& program) const {
  program.use();
  program.set("colour", collider_colour);
  for (size_t i = 0; i < solids_.solids.size(); ++i) {
    if (solids_.solids[i].form != Form::disc) draw(program, i);
  }
}

void SolidModels::draw_discs(const Program& program, const Vector3f& eye) const {
  program.use();
  program.set("colour", collider_colour);
  for (size_t i = 0; i < solids_.solids.size(); ++i) {
    if (solids_.solids[i].form != Form::disc) continue;
    const Vector3f from = eye - places_[i].block<3, 1>(0, 3);
    if (from.dot(places_[i].block<3, 1>(0, 2)) > 0) draw(program, i);
  }
}

void SolidModels::draw(const Program& program, size_t i) const {
  const Solid& solid = solids_.solids[i];
  Eigen::Matrix4f turned = Eigen::Matrix4f::Identity();
  turned.block<3, 3>(0, 0) = places_[i].block<3, 3>(0, 0).inverse().transpose();
  program.set("model", places_[i]);
  program.set("turned", turned);
  if (solid.form == Form::collider_mesh)
    collider_meshes_[solid.mesh].draw();
  else
    (solid.form == Form::mesh ? meshes_[solid.mesh] : forms_[size_t(solid.form)]).draw();
}

void SolidModels::draw_capsules(const Program& program) const {
  program.use();
  program.set("colour", collider_colour);
  capsules_.draw();
}

}  // namespace weft::render
