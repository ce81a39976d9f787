#include "render/painter.h"

#include "render/gl.h"
#include "render/shaders.h"
#include "render/solid_models.h"
#include "render/stage.h"
#include "render/targets.h"
#include "render/weavings.h"

#include <Eigen/Geometry>

namespace weft::render {

/// The objects of OpenGL, in the order in which they are drawn.
struct Painter::Parts {
  Parts(const io::Scene& scene, const io::Surface& start, const Framing& framing,
        const Reach& reach)
      : stage(make_stage(scene, framing)),
        canvas(scene.camera.width, scene.camera.height),
        solids(make_solids(scene, reach.depths(), stage.seen, ground_plane(scene, up_of(scene))),
               scene),
        weavings(scene, start, stage),
        up(up_of(scene).cast<float>()) {
    Eigen::Vector3f across = stage.ground_normal.unitOrthogonal();
    ground_model.setIdentity();
    ground_model.block<3, 1>(0, 0) = 14 * stage.radius * across;
    ground_model.block<3, 1>(0, 1) = 14 * stage.radius * stage.ground_normal.cross(across);
    ground_model.block<3, 1>(0, 2) = stage.ground_normal;
  }

  void light(const Program& program) const {
    program.use();
    program.set("camera", stage.camera);
    program.set("shadow", stage.shadow);
    program.set("eye", stage.eye);
    program.set("light", stage.light);
    program.set("up", up);
    program.set("texel", 2.04f * stage.radius / float(ShadowMap::size));
    program.set("depth", 0);
  }

  Eigen::Vector3f ground_at(double time) const {
    return stage.ground + float(time) * stage.ground_velocity;
  }
  bool shows_ground(double time) const {
    return (stage.eye - ground_at(time)).dot(stage.ground_normal) > 0;
  }

  void draw_shadows(double time) const {
    shadows.begin();
    for (const Program* program : {&cloth_depth, &solid_depth, &capsule_depth}) {
      program->use();
      program->set("camera", stage.shadow);
      program->set("ground", ground_at(time));
      program->set("ground_normal", stage.ground_normal);
    }
    if (shows_ground(time)) glEnable(GL_CLIP_DISTANCE0);
    draw_colliders(solid_depth, capsule_depth);
    draw_cloths(cloth_depth, capsule_depth);
    glDisable(GL_CLIP_DISTANCE0);
    shadows.soften(blur, nothing);
  }

  void draw_colliders(const Program& solid, const Program& capsule) const {
    solids.draw_solids(solid);
    solids.draw_capsules(capsule);
  }

  void draw_cloths(const Program& cloth, const Program& capsule) const {
    weavings.draw_cloths(cloth);
    weavings.draw_bars(capsule);
  }

  void draw_sky() const {
    sky.use();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(nothing.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
  }

  // The ground hides nothing from below.
  void draw_ground(double time) const {
    if (!shows_ground(time)) return;
    Eigen::Matrix4f place = ground_model;
    place.block<3, 1>(0, 3) = ground_at(time);
    light(ground);
    ground.set("model", place);
    ground.set("normal", stage.ground_normal);
    ground.set("soft", 1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(nothing.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_BLEND);
  }

  Stage stage;
  Canvas canvas;
  ShadowMap shadows;
  SolidModels solids;
  Weavings weavings;
  Witness cloth_in_view;
  Eigen::Vector3f up;
  Eigen::Matrix4f ground_model;
  VertexArray nothing;
  Program cloth{{shadow_functions, cloth_vertices},
                {shadow_functions, light_functions, cloth_fragments}};
  Program solid{{ground_functions, solid_vertices},
                {shadow_functions, light_functions, solid_fragments}};
  Program capsule{{ground_functions, capsule_vertices},
                  {shadow_functions, light_functions, solid_fragments}};
  Program ground{{ground_vertices}, {shadow_functions, light_functions, ground_fragments}};
  Program cloth_depth{{ground_functions, caster_vertices}, {no_fragments}};
  Program solid_depth{{ground_functions, solid_vertices}, {no_fragments}};
  Program capsule_depth{{ground_functions, capsule_vertices}, {no_fragments}};
  Program sky{{screen_vertices}, {sky_fragments}};
  Program blur{{screen_vertices}, {blur_fragments}};
};

Painter::Painter(const io::Scene& scene, const io::Surface& start, const Framing& framing,
                 const Reach& reach)
    : parts_(std::make_unique<Parts>(scene, start, framing, reach)) {}

Painter::~Painter() = default;

std::vector<std::string> Painter::problems() const {
  std::vector<std::string> lines = parts_->solids.problems();
  if (parts_->cloth_in_view.never_passed()) {
    lines.push_back(
        "$.camera: no cloth is in any picture (all are out of its view, or behind colliders) move "
        "\"eye\" or \"target\"");
  }
  return lines;
}

Image Painter::draw(const io::Surface& surface, double time) {
  Parts& p = *parts_;
  p.weavings.update(surface, p.stage.origin);
  p.solids.update(surface, time, p.stage.origin);

  p.draw_shadows(time);
  p.canvas.begin();
  p.shadows.bind();
  p.draw_sky();
  p.draw_ground(time);
  for (const Program* program : {&p.cloth, &p.solid, &p.capsule}) p.light(*program);
  p.draw_colliders(p.solid, p.capsule);
  p.solids.draw_discs(p.solid, p.stage.eye);
  p.cloth_in_view.begin();
  p.draw_cloths(p.cloth, p.capsule);
  p.cloth_in_view.end();
  return p.canvas.read();
}

}  // namespace weft::render
