#include "render/sight.h"

#include "render/reach.h"
#include "render/ridges.h"
#include "render/solids.h"
#include "render/stage.h"

#include "io/text_cursor.h"

#include <algorithm>
#include <cmath>

namespace weft::render {

namespace {

bool is_inside(const io::MeshColliderScene& d, const Vector3d& point) {
  const Eigen::Matrix3d turn = rotation(d.pose.axis, d.pose.degrees);
  return Ridges(*d.mesh, d.scale, true)
      .enclose(turn.transpose() * (point - vector(d.pose.translate)));
}

}  // namespace

Sight::Sight(const io::Scene& scene, const Framing& framing)
    : scene_(scene),
      axes_(framing.axes()),
      half_width_(framing.half_width()),
      half_height_(framing.half_height()) {}

// A surface whose vertices are all beyond one side of the pyramid of view is certainly out of it.
void Sight::add(const io::Surface& surface) {
  const io::CameraScene& camera = scene_.camera;
  Box box;
  for (const double3& p : surface.positions) box.add(vector(p));
  largest_ = std::max(largest_, box.empty() ? 0 : box.radius());
  if (!camera.eye) return;
  const Vector3d eye = vector(*camera.eye);
  unsigned outside = 31;
  double left = 1, right = -1, low = 1, high = -1;  // -1 to 1 is in the picture
  for (const double3& p : surface.positions) {
    const Vector3d from = vector(p) - eye;
    const double ahead = -axes_.back.dot(from);
    const double wide = half_width_ * ahead, tall = half_height_ * ahead;
    const double x = axes_.right.dot(from), y = axes_.up.dot(from);
    outside &= unsigned(!(ahead > 0)) | unsigned(x < -wide) << 1 | unsigned(x > wide) << 2 |
               unsigned(y < -tall) << 3 | unsigned(y > tall) << 4;
    const double across = ahead > 0 ? std::clamp(x / wide, -1.0, 1.0) : std::copysign(1.0, x);
    const double along = ahead > 0 ? std::clamp(y / tall, -1.0, 1.0) : std::copysign(1.0, y);
    left = std::min(left, across), right = std::max(right, across);
    low = std::min(low, along), high = std::max(high, along);
  }
  if (outside != 0) return;
  seen_ = true;
  pixels_ =
      std::max({pixels_, 0.5 * (right - left) * camera.width, 0.5 * (high - low) * camera.height});
}

std::vector<std::string> Sight::problems(const Framing& framing) const {
  if (scene_.camera.eye) return problems_of_eye(framing);
  const double distance = (framing.eye() - framing.box().center()).norm();
  const double pixels = largest_ / (half_height_ * distance) * scene_.camera.height;
  if (largest_ == 0 || !(pixels < 2)) return {};
  return {
      "$.camera: the cloths are less than 2 pixels large (all of their long way is in the picture) "
      "give it an \"eye\" and a \"target\""};
}

std::vector<std::string> Sight::problems_of_eye(const Framing& framing) const {
  std::vector<std::string> lines;
  const io::CameraScene& camera = scene_.camera;
  if (seen_ && pixels_ < 2) {
    lines.push_back(
        "$.camera: the cloths are less than 2 pixels large (they are far away for the "
        "angle of view) move \"eye\" nearer or lower \"field_of_view\"");
  } else if (seen_ && framing.nearest() < nearest_drawn(framing.box().radius())) {
    lines.push_back(
        "$.camera.eye: cloth comes so near that it is cut open (all that moves covers " +
        io::number_text(std::round(2000 * framing.box().radius()) / 1000) +
        " m) move \"eye\" away from it");
  }
  const Vector3d eye = vector(*camera.eye);
  for (size_t i = 0; i < scene_.colliders.size(); ++i) {
    const auto depth = depth_in(scene_.colliders[i], 0, eye);
    const auto* mesh = std::get_if<io::MeshColliderScene>(&scene_.colliders[i]);
    const bool inside = depth ? depth->value > 0 : mesh && mesh->closed && is_inside(*mesh, eye);
    if (!inside) continue;
    lines.push_back("$.camera.eye: is inside of $.colliders[" + std::to_string(i) +
                    "] at the start (it hides what is outside) move one of them");
  }
  return lines;
}

}  // namespace weft::render
