// The key "camera".
#include "io/scene_parts.h"

#include <cmath>

namespace weft::io {
namespace {

double3 minus(double3 a, double3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double length(double3 v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
double3 cross(double3 a, double3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

void read_view(const Node& node, CameraScene& camera) {
  const auto eye = node.find("eye"), target = node.find("target");
  if (!eye && !target) return;
  if (!eye || !target) {
    node.fail(std::string("has \"") + (eye ? "eye" : "target") + "\" alone (a view has both) add " +
              (eye ? "\"target\"" : "\"eye\"") + ", or leave both out");
  }
  camera.eye = eye->vector();
  camera.target = target->vector();
  const double distance = length(minus(*camera.eye, *camera.target));
  if (!(distance > 0) || !std::isfinite(distance)) {
    target->fail(
        "is no direction from \"eye\" (they are equal, or too far apart) move one of them");
  }
}

void read_up(const Node& node, CameraScene& camera) {
  const auto key = node.find("up");
  if (!key) return;
  camera.up = key->vector();
  const double size = length(*camera.up);
  if (!(size > 0) || !std::isfinite(size)) {
    key->fail("has no direction (it is zero, or too long) give another vector");
  }
  if (!camera.eye) return;
  const double3 view = minus(*camera.eye, *camera.target);
  if (!(length(cross(view, *camera.up)) > 1e-6 * size * length(view))) {
    key->fail("lies along the view from \"eye\" to \"target\" (nothing is upright then) turn it");
  }
}

uint32_t read_pixels(const Node& node, const char* name, uint32_t otherwise) {
  const auto key = node.find(name);
  if (!key) return otherwise;
  return uint32_t(
      key->integer(least_pixels, most_pixels, "a side of a picture has so many pixels"));
}

}  // namespace

CameraScene read_camera(const Node& node) {
  node.require_object({"eye", "target", "up", "field_of_view", "width", "height"});
  CameraScene camera;
  read_view(node, camera);
  read_up(node, camera);
  if (const auto key = node.find("field_of_view")) {
    camera.field_of_view = key->number(Sign::positive);
    if (camera.field_of_view < least_degrees || camera.field_of_view > most_degrees) {
      key->out_of_range("the height of a picture is 0.01 to 150 degrees",
                        "give a number >= 0.01 and <= 150");
    }
  }
  camera.width = read_pixels(node, "width", camera.width);
  camera.height = read_pixels(node, "height", camera.height);
  return camera;
}

}  // namespace weft::io
