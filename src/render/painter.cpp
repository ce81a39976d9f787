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

  void draw_casters(const Eigen::Matrix4f& camera, const Program& cloth, const Program& solid,
                    const Program& capsule) const {
    for (const Program* program : {&cloth, &solid, &capsule}) {
      program->use();
      program->set("camera", camera);
    }
    weavings.draw_cloths(cloth);
    solids.draw_solids(solid);
    solids.draw_capsules(capsule);
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
    const Eigen::Vector3f now = stage.ground + float(time) * stage.ground_velocity;
    if (!((stage.eye - now).dot(stage.ground_normal) > 0)) return;
    Eigen::Matrix4f place = ground_model;
    place.block<3, 1>(0, 3) = now;
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
  Eigen::Vector3f up;
  Eigen::Matrix4f ground_model;
  VertexArray nothing;
  Program cloth{{shadow_functions, cloth_vertices},
                {shadow_functions, light_functions, cloth_fragments}};
  Program solid{{solid_vertices}, {shadow_functions, light_functions, solid_fragments}};
  Program capsule{{capsule_vertices}, {shadow_functions, light_functions, solid_fragments}};
  Program ground{{ground_vertices}, {shadow_functions, light_functions, ground_fragments}};
  Program cloth_depth{{caster_vertices}, {no_fragments}};
  Program solid_depth{{solid_vertices}, {no_fragments}};
  Program capsule_depth{{capsule_vertices}, {no_fragments}};
  Program sky{{screen_vertices}, {sky_fragments}};
  Program blur{{screen_vertices}, {blur_fragments}};
};

Painter::Painter(const io::Scene& scene, const io::Surface& start, const Framing& framing,
                 const Reach& reach)
    : parts_(std::make_unique<Parts>(scene, start, framing, reach)) {}

Painter::~Painter() = default;

std::vector<std::string> Painter::problems() const { return parts_->solids.problems(); }

Image Painter::draw(const io::Surface& surface, double time) {
  Parts& p = *parts_;
  p.weavings.update(surface, p.stage.origin);
  p.solids.update(surface, time, p.stage.origin);

  p.shadows.begin();
  p.draw_casters(p.stage.shadow, p.cloth_depth, p.solid_depth, p.capsule_depth);
  p.shadows.soften(p.blur, p.nothing);

  p.canvas.begin();
  p.shadows.bind();
  p.draw_sky();
  p.draw_ground(time);
  for (const Program* program : {&p.cloth, &p.solid, &p.capsule}) p.light(*program);
  p.draw_casters(p.stage.camera, p.cloth, p.solid, p.capsule);
  p.solids.draw_discs(p.solid, p.stage.eye);
  return p.canvas.read();
}

}  // namespace weft::render
