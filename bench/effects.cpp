#include "bench/effects.h"

#include <cmath>
#include <cstring>
#include <memory>

#include "bench/interleave.h"
#include "bench/sheets.h"

namespace weft::bench {

namespace {

constexpr uint32_t n = 256;
constexpr double far_away = 1000;

using Options = SteppedWorld::Options;

struct Effect {
  std::string name;
  Options options;
};

Options dressed(std::function<void(ClothDesc&)> dress) {
  Options o;
  o.dress = std::move(dress);
  return o;
}
Options furnished(std::function<void(Context&, World&, ClothId)> furnish) {
  Options o;
  o.furnish = std::move(furnish);
  return o;
}

void lay_down(World& world) { world.set_gravity({0, 0, -9.81}); }

/// The sheet lies on what is added: gravity runs across it.
template <class Desc>
Options lying_on(Desc desc) {
  return furnished([desc](Context&, World& world, ClothId) {
    lay_down(world);
    if constexpr (std::is_same_v<Desc, SphereDesc>) {
      (void)world.create_sphere(desc);
    } else if constexpr (std::is_same_v<Desc, PlaneDesc>) {
      (void)world.create_plane(desc);
    } else if constexpr (std::is_same_v<Desc, CapsuleDesc>) {
      (void)world.create_capsule(desc);
    } else if constexpr (std::is_same_v<Desc, CylinderDesc>) {
      (void)world.create_cylinder(desc);
    } else {
      (void)world.create_box(desc);
    }
  });
}

SphereDesc sphere(double x, double y, double z, double radius) {
  SphereDesc d;
  d.center = {x, y, z};
  d.radius = radius;
  return d;
}
PlaneDesc plane(double offset, double friction) {
  PlaneDesc d;
  d.normal = {0, 0, 1};
  d.offset = offset;
  d.friction = friction;
  return d;
}

/// 8 x 8 of them side by side, a millimetre or a kilometre below the sheet.
Options spheres_below(double depth, bool touching) {
  return furnished([depth, touching](Context&, World& world, ClothId) {
    lay_down(world);
    const double radius = touching ? 0.06 : 0.05;
    for (int i = 0; i < 64; ++i) {
      (void)world.create_sphere(
          sphere((i % 8 + 0.5) / 8, double(i / 8) / 8 + 1.0 / 16, -depth, radius));
    }
  });
}

/// A ball of triangles; the sheet lies on its top.
void add_ball(Context& context, World& world, double z, uint32_t rings) {
  std::vector<double3> x;
  std::vector<uint32_t> triangles;
  const uint32_t around = 2 * rings;
  const double pi = 3.141592653589793;
  for (uint32_t r = 0; r <= rings; ++r) {
    for (uint32_t a = 0; a < around; ++a) {
      const double t = pi * r / rings, p = 2 * pi * a / around;
      x.push_back(
          {0.4 * std::sin(t) * std::cos(p), 0.4 * std::sin(t) * std::sin(p), 0.4 * std::cos(t)});
    }
  }
  for (uint32_t r = 0; r < rings; ++r) {
    for (uint32_t a = 0; a < around; ++a) {
      const uint32_t i = r * around + a, j = r * around + (a + 1) % around;
      for (const uint32_t v : {i, i + around, j + around, i, j + around, j}) triangles.push_back(v);
    }
  }
  ColliderMeshDesc desc;
  desc.positions = View<double3>(x);
  desc.indices = triangles;
  desc.thickness = 0.005;
  const auto mesh = context.cook(desc);
  MeshColliderDesc collider;
  collider.mesh = *mesh;
  collider.pose.translate = {0.5, 0.5, z};
  (void)world.create_mesh(collider);
}
Options mesh_ball(double z) {
  return furnished([z](Context& context, World& world, ClothId) {
    lay_down(world);
    add_ball(context, world, z, 132);  // 69,696 triangles
  });
}

Options wind(double speed, double density) {
  return furnished([speed, density](Context&, World& world, ClothId) {
    WindDesc d;
    d.velocity = {0, 0, speed};
    d.air_density = density;
    world.set_wind(d);
  });
}

std::vector<Effect> effects() {
  const std::vector<VertexForce> force(1);
  const std::vector<Pin> pins{{0, 0}, {n - 1, 0}};
  const std::vector<PinMotion> motions(1, PinMotion{{0, 0, 0}, {0, 0, 1e-4}, 10});
  BoxDesc box;
  box.center = {0.5, 0.5, -0.2};
  box.half = {0.3, 0.3, 0.2};
  CapsuleDesc capsule;
  capsule.a = {0.2, 0.5, -0.2};
  capsule.b = {0.8, 0.5, -0.2};
  capsule.radius = 0.2;
  CylinderDesc cylinder;
  cylinder.a = {0.5, 0.5, -1};
  cylinder.b = {0.5, 0.5, 0};
  cylinder.radius = 0.3;
  SphereDesc moving = sphere(0.5, 0.5, -0.4, 0.4);
  moving.velocity = {0.01, 0, 0};
  SphereDesc rough = sphere(0.5, 0.5, -0.4, 0.4);
  rough.friction = 0.5;
  Options sphere_and_plane = furnished([](Context&, World& world, ClothId) {
    lay_down(world);
    (void)world.create_sphere(sphere(0.5, 0.5, -0.4, 0.4));
    (void)world.create_plane(plane(-0.3, 0));
  });
  Options both_far = furnished([](Context&, World& world, ClothId) {
    lay_down(world);
    (void)world.create_sphere(sphere(0.5, 0.5, -far_away, 0.4));
    (void)world.create_plane(plane(-far_away, 0));
  });
  return {
      {"central drag, used", dressed([](ClothDesc& d) { d.drag = 1e-5; })},
      {"spring damping, used", dressed([](ClothDesc& d) { d.spring_damping = 1e-5; })},
      {"constant forces, used", dressed([force](ClothDesc& d) { d.forces = force; })},
      {"moving pins, used", dressed([pins, motions](ClothDesc& d) {
         d.pins = pins;
         d.motions = motions;
       })},
      {"wind, used", wind(5, 1.225)},
      {"wind without air", wind(5, 0)},
      {"plane, all of the sheet on it", lying_on(plane(0, 0))},
      {"plane with friction, all on it", lying_on(plane(0, 0.5))},
      {"sphere, used", lying_on(sphere(0.5, 0.5, -0.4, 0.4))},
      {"sphere with friction, used", lying_on(rough)},
      {"moving sphere, used", lying_on(moving)},
      {"capsule, used", lying_on(capsule)},
      {"cylinder, used", lying_on(cylinder)},
      {"box, used", lying_on(box)},
      {"sphere and plane, used", sphere_and_plane},
      {"sphere and plane, out of reach", both_far},
      {"64 spheres, used", spheres_below(0.05, true)},
      {"64 spheres, near but not touched", spheres_below(0.06, false)},
      {"64 spheres, out of reach", spheres_below(far_away, false)},
      {"mesh of 69,696 triangles, used", mesh_ball(-0.405)},
      {"mesh of 69,696 triangles, out of reach", mesh_ball(-far_away)},
      {"sleep, awake", dressed([](ClothDesc& d) { d.sleep_speed = 1e-6; })},
      {"sleep, asleep",
       [] {
         Options o = furnished([](Context&, World& world, ClothId) {
           world.set_gravity({0, 0, 0});
         });
         o.dress = [](ClothDesc& d) {
           d.sleep_speed = 1e-3;
           d.sleep_time = 0;
         };
         return o;
       }()},
  };
}

Row figure(const std::string& name, const char* metric, const char* unit, double value) {
  return {"effects", name, metric, unit, value, value, value, 1};
}

/// Of the pass of a substep, as the plan counts it.
double flops_of(World& world) {
  const auto plan = world.plan();
  for (uint32_t i = 0; plan && i < plan->passes.count; ++i) {
    if (std::strcmp(plan->passes[i].stage, "advance") == 0) {
      return plan->passes[i].flops_per_particle;
    }
  }
  return 0;
}

struct Measured {
  std::shared_ptr<SteppedWorld> world;
  size_t index;
};

Measured add(Interleaved& runs, const std::string& name, const Options& options) {
  auto world = std::make_shared<SteppedWorld>(SteppedWorld::sheet(n, Stencil::seed12, options));
  for (int call = 0; call < 4; ++call) world->advance();
  return {world, runs.add({name, world->particle_steps(), [world] { world->advance(); }})};
}

void append_normals(int rounds, std::ostream& progress, const Measured& bare,
                    std::vector<Row>& rows) {
  Interleaved runs("effects");
  auto out = std::make_shared<std::vector<float3>>(n * n);
  auto world = bare.world;
  runs.add({"normals, one call with the copy to the caller", world->particles(), [world, out] {
              world->advance();
              (void)world->world().read_normals(world->cloth(), out->data());
            }});
  runs.add({"a call without normals", world->particles(), [world] { world->advance(); }});
  runs.run(rounds, progress);
  runs.append_difference("normals, one call with the copy to the caller", "ns/particle", 0, 1,
                         rows);
}

}  // namespace

std::vector<Row> run_effects(bool quick, std::ostream& progress) {
  const int rounds = quick ? 9 : 31;
  std::vector<Row> rows;
  Interleaved runs("effects");
  const Measured bare = add(runs, "bare sheet", {});
  std::vector<Measured> measured;
  const std::vector<Effect> all = effects();
  for (const Effect& e : all) measured.push_back(add(runs, e.name, e.options));
  runs.run(rounds, progress);
  runs.append_times("ns_per_particle_step", "ns", rows);
  const double bytes = double(bare.world->world().stats().bytes_state);
  const double flops = flops_of(bare.world->world());
  rows.push_back(figure("bare sheet", "flops", "1/particle", flops));
  const double passes = (*bare.world->world().plan()).passes.count;
  rows.push_back(figure("bare sheet", "bytes", "B/particle", bytes / bare.world->particles()));
  rows.push_back(figure("bare sheet", "passes", "1", passes));
  for (size_t i = 0; i < all.size(); ++i) {
    World& world = measured[i].world->world();
    const double more = double(world.stats().bytes_state) - bytes;
    runs.append_difference(all[i].name, "ns", measured[i].index, bare.index, rows);
    runs.append_ratio(all[i].name, measured[i].index, bare.index, rows);
    rows.push_back(
        figure(all[i].name, "bytes_added", "B/particle", more / measured[i].world->particles()));
    rows.push_back(figure(all[i].name, "flops_added", "1/particle", flops_of(world) - flops));
    rows.push_back(
        figure(all[i].name, "passes_added", "1", double((*world.plan()).passes.count) - passes));
  }
  append_normals(rounds, progress, bare, rows);
  return rows;
}

}  // namespace weft::bench
