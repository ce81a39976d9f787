#include "render/painter.h"

#include "render/cloths.h"
#include "render/shaders.h"
#include "render/stage.h"
#include "render/targets.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace weft::render {
namespace {

const Vector3f collider_colour{0.62f, 0.60f, 0.57f};

/// A collider on the device.
struct Body {
  Model model;
  Vector3f velocity;
  bool plane;
};

}  // namespace

/// The objects of OpenGL, and a picture's time.
struct Painter::Parts {
  Parts(const io::Scene& scene, const io::Surface& start, const std::vector<Solid>& solids)
      : stage(make_stage(scene, start, solids)),
        canvas(scene.camera.width, scene.camera.height),
        cloths(scene, start, 0.012f * stage.radius) {
    for (const Solid& solid : solids) {
      if (solid.kind == Solid::Kind::ground) continue;
      bodies.push_back({Model(solid.surface, stage.origin), solid.velocity.cast<float>(),
                        solid.kind == Solid::Kind::plane});
    }
  }

  /// Before the first draw of a picture.
  void update(const io::Surface& surface, double now) {
    cloths.update(surface, stage.origin);
    time = float(now);
    ground = stage.ground + time * stage.ground_velocity;
    if (!stage.floor) return;
    const Vector3d up = stage.up.cast<double>();
    double lowest = up.dot(stage.ground.cast<double>());
    for (const double3& p : surface.positions) {
      lowest = std::min(lowest, up.dot(vector(p) - stage.origin));
    }
    ground = float(lowest) * stage.up;
  }
  bool shows_ground() const { return (stage.eye - ground).dot(stage.ground_normal) > 0; }

  void light(const Program& program) const {
    program.use();
    program.set("camera", stage.camera);
    program.set("shadow", stage.shadow);
    program.set("eye", stage.eye);
    program.set("light", stage.light);
    program.set("up", stage.up);
    program.set("texel", 2.04f * stage.radius / float(ShadowMap::size));
    program.set("lift", 0.01f * stage.radius);
  }

  void draw_shadows() const {
    shadows.begin();
    for (const Program* program : {&solid_depth, &bar_depth}) {
      program->use();
      program->set("camera", stage.shadow);
      program->set("ground", ground);
      program->set("ground_normal", stage.ground_normal);
    }
    if (shows_ground()) glEnable(GL_CLIP_DISTANCE0);
    draw_bodies(solid_depth, false);
    solid_depth.set("moved", Vector3f(0, 0, 0));
    cloths.draw_sheets(solid_depth);
    cloths.draw_bars(bar_depth);
    glDisable(GL_CLIP_DISTANCE0);
  }

  /// A plane hides nothing from behind.
  void draw_bodies(const Program& program, bool planes) const {
    program.use();
    program.set("colour", collider_colour);
    for (const Body& body : bodies) {
      if (body.plane != planes) continue;
      program.set("moved", Vector3f(time * body.velocity));
      body.model.draw();
    }
  }

  // The ground hides nothing from below.
  void draw_background() const {
    sky.use();
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(nothing.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
    if (!shows_ground()) return;
    const Vector3f across = 14 * stage.radius * stage.ground_normal.unitOrthogonal();
    light(ground_program);
    ground_program.set("middle", ground);
    ground_program.set("across", across);
    ground_program.set("normal", stage.ground_normal);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_BLEND);
  }

  Stage stage;
  Canvas canvas;
  ShadowMap shadows;
  std::vector<Body> bodies;
  Cloths cloths;
  VertexArray nothing;
  Program cloth{{shadow_functions, depth_functions, cloth_vertices},
                {shadow_functions, light_functions, cloth_fragments}};
  Program bar{{ground_functions, depth_functions, bar_vertices},
              {shadow_functions, light_functions, solid_fragments}};
  Program solid{{ground_functions, solid_vertices},
                {shadow_functions, light_functions, solid_fragments}};
  Program ground_program{{ground_vertices}, {shadow_functions, light_functions, ground_fragments}};
  Program bar_depth{{ground_functions, depth_functions, bar_vertices}, {no_fragments}};
  Program solid_depth{{ground_functions, solid_vertices}, {no_fragments}};
  Program sky{{screen_vertices}, {sky_fragments}};
  float time = 0;
  Vector3f ground{0, 0, 0};  ///< a point of it
};

Painter::Painter(const io::Scene& scene, const io::Surface& start) {
  Box region = box_of(start.positions);
  if (region.radius() < 1e-9) region = region.grown(1e-3);
  parts_ = std::make_unique<Parts>(scene, start, make_solids(scene, region));
}

Painter::~Painter() = default;

Image Painter::draw(const io::Surface& surface, double time) {
  Parts& p = *parts_;
  p.update(surface, time);
  p.draw_shadows();
  p.canvas.begin();
  p.draw_background();
  for (const Program* program : {&p.cloth, &p.bar, &p.solid}) p.light(*program);
  p.draw_bodies(p.solid, false);
  glEnable(GL_CULL_FACE);
  p.draw_bodies(p.solid, true);
  glDisable(GL_CULL_FACE);
  p.cloths.draw_sheets(p.cloth);
  p.cloths.draw_bars(p.bar);
  return p.canvas.read();
}

}  // namespace weft::render
