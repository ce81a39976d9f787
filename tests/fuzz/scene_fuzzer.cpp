// Any bytes as a scene file: read, or refused with an InputError. Mesh files are not there.
#include "io/scene.h"

#include "fuzz.h"

using namespace weft;

static void check_cloth(const io::ClothScene& cloth) {
  const uint32_t vertices = io::vertex_count(cloth.shape);
  require(vertices > 0);
  for (const Pin& pin : cloth.pins) require(pin.vertex < vertices);
  for (const VertexForce& force : cloth.forces) require(force.vertex < vertices);
  require(cloth.masses.empty() || cloth.masses.size() == vertices);
  require(cloth.velocities.empty() || cloth.velocities.size() == vertices);
  const auto* network = std::get_if<io::NetworkShape>(&cloth.shape);
  if (!network) return;
  for (const double3& p : network->positions) require(is_finite(p));
  for (const Spring& spring : network->springs) {
    require(spring.a < vertices && spring.b < vertices);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const io::Scene scene = io::read_scene_text(text_of(data, size), "no/such/folder/s.json");
    require(!scene.cloths.empty());
    for (const io::ClothScene& cloth : scene.cloths) check_cloth(cloth);
    require(scene.time.frame > 0 && scene.time.duration >= 0);
  } catch (const io::InputError& error) {
    require_message(error);
  }
  return 0;
}
