// A scene file as plain data, checked: every value is in range and every index names something.
#pragma once

#include "weft/world.hpp"

#include "io/mesh.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace weft::io {

struct TimeSettings {
  double duration = 1;
  double frame = 1.0 / 60;
  uint32_t substeps = 0;      ///< 0: automatic
  uint32_t max_substeps = 0;  ///< 0: no limit
};

enum class Method : uint8_t { verlet, rk4, implicit_euler, implicit_midpoint, xpbd };
enum class EnergyGuard : uint8_t { automatic, on, off };

struct SolverSettings {
  Method method = Method::verlet;  ///< "integrator"
  std::vector<uint8_t> ladder{automatic_ladder};
  Form form = Form::summed;
  Start start = Start::taylor;
  Precision precision = Precision::float32;
  Evaluation evaluation = Evaluation::automatic;
  Accumulate accumulate = Accumulate::native;
  bool deterministic = true;
  double safety = 0.9;
  EnergyGuard energy_guard = EnergyGuard::automatic;
  bool unsafe = false;
};

struct GridShape {
  uint32_t rows = 1, columns = 1;
  double width = 1, height = 1;
  Stencil stencil = Stencil::seed12;
};
struct MeshShape {
  std::shared_ptr<const Mesh> mesh;  ///< shared by all that name the same file
  bool bend = false;
  double weld_distance = 0;
};
struct NetworkShape {
  std::vector<double3> positions;
  std::vector<Spring> springs;
};
using Shape = std::variant<GridShape, MeshShape, NetworkShape>;

struct ClothScene : ClothSettings {
  std::string name;
  Shape shape;
  double scale = 1;
  Pose pose;
  Mass::Kind mass_kind = Mass::Kind::total;
  double mass = 1;
  std::vector<double> masses;
  Stiffness stiffness{0};
  double rest_length = initial_rest_length;
  std::vector<Pin> pins;  ///< a vertex at most once, ascending
  std::vector<PinMotion> motions;
  double3 velocity{0, 0, 0};
  std::vector<double3> velocities;
  std::vector<VertexForce> forces;
};

struct MeshColliderScene {
  std::shared_ptr<const Mesh> mesh;  ///< shared by all that name the same file
  double scale = 1, thickness = 0.005;
  bool closed = false;
  double weld_distance = 0;
  Pose pose;
  double3 velocity{0, 0, 0};
  double friction = 0;
  uint32_t layers = ~0u;
};
using ColliderScene =
    std::variant<SphereDesc, PlaneDesc, CylinderDesc, CapsuleDesc, BoxDesc, MeshColliderScene>;

struct SelfCollisionScene {
  bool complete = false;
  double distance = 0.01, friction = 0, cell = 0.02;
  uint32_t grids = 8;
  bool diagonal = false;
  std::optional<uint32_t> window;
  std::optional<double> skin;
};

constexpr int64_t least_pixels = 16, most_pixels = 8192;    ///< of a side of a picture
constexpr double least_degrees = 0.01, most_degrees = 150;  ///< of its height

/// Only pictures look at it.
struct CameraScene {
  std::optional<double3> eye,
      target;                 ///< m; both or neither: then all that moves is in the picture
  std::optional<double3> up;  ///< against gravity when absent
  double field_of_view = 30;  ///< degrees, of the height
  uint32_t width = 640, height = 360;  ///< pixels
};

struct Scene {
  std::string file;
  std::vector<std::string> meshes;  ///< paths of the files that it names
  double3 gravity{0, -9.81, 0};
  TimeSettings time;
  SolverSettings solver;
  std::vector<ClothScene> cloths;
  std::vector<ColliderScene> colliders;
  std::optional<WindDesc> wind;
  std::optional<SelfCollisionScene> self_collision;
  CameraScene camera;
};

/// Reads, checks and refuses: an InputError starts with the file and the JSON path.
Scene read_scene(const std::string& path);
/// The same from memory; mesh files are looked for in the folder of `path`.
Scene read_scene_text(std::string_view text, const std::string& path);

uint32_t vertex_count(const Shape&);
/// ceil(duration/frame - 1e-6). InputError, naming `path`, above 2^53.
uint64_t frame_count(const TimeSettings&, const std::string& path);

}  // namespace weft::io
