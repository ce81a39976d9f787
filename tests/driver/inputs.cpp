// What acts on cloths: pins, forces, gravity, wind.
#include "run.h"

namespace weft_tests::driver {

using weft::Status;

Outcome Run::move_pins(Random& r, ModelWorld& w) {
  weft::ClothId id;
  ModelCloth* cloth = pick_cloth(r, w, id);
  const uint32_t n = cloth ? cloth->vertices : 4;
  std::vector<uint32_t> vertices;
  std::vector<weft::double3> targets;
  for (uint32_t i = r.below(5); i > 0 && n > 0; --i) {
    vertices.push_back(r.below(n));
    targets.push_back(place(r, w, 0.6));
  }
  Points points = stored(r, targets);
  Expect expect = !cloth ? Expect::handle : is_extreme_ ? Expect::any : Expect::ok;
  weft::View<uint32_t> view = vertices;
  if (cloth && !vertices.empty() && r.chance(0.2)) {
    expect = Expect::refusal;
    switch (r.below(4)) {
      case 0:
        vertices.back() = n + r.below(3);
        break;
      case 1:
        spoil(r, points);
        break;
      case 2:
        --points.view.count;
        break;
      default:
        view.data = nullptr;
    }
  }
  const Status status = w.world.move_pins(id, view, points.view);
  if (status == Status::ok && cloth) {
    for (const uint32_t v : vertices) cloth->pinned[v] = true;
  }
  return {status, expect, 0};
}

Outcome Run::set_skinned_targets(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const ModelCloth* cloth = pick_cloth(r, w, id);
  const uint32_t n = cloth ? cloth->vertices : 4;
  std::vector<weft::double3> targets;
  for (uint32_t v = 0; v < n; ++v) targets.push_back(place(r, w, 0.6));
  Points points = stored(r, targets);
  Expect expect = !cloth ? Expect::handle : is_extreme_ ? Expect::any : Expect::ok;
  if (cloth && n > 0 && r.chance(0.2)) {
    expect = Expect::refusal;
    if (r.chance(0.3)) {
      --points.view.count;
    } else {
      spoil(r, points);
    }
  }
  return {w.world.set_skinned_targets(id, points.view), expect, 0};
}

Outcome Run::release_pins(Random& r, ModelWorld& w) {
  weft::ClothId id;
  ModelCloth* cloth = pick_cloth(r, w, id);
  std::vector<uint32_t> vertices;
  Expect expect = cloth ? Expect::ok : Expect::handle;
  for (uint32_t v = 0; cloth && v < cloth->vertices; ++v) {
    if (cloth->pinned[v] ? r.chance(0.5) : r.chance(0.01)) vertices.push_back(v);
  }
  for (const uint32_t v : vertices) {
    if (!cloth->pinned[v]) expect = Expect::refusal;
  }
  if (!vertices.empty() && r.chance(0.2)) vertices.push_back(vertices.front());
  if (cloth && r.chance(0.1)) {
    vertices.push_back(cloth->vertices + r.below(2));
    expect = Expect::refusal;
  }
  const Status status = w.world.release_pins(id, vertices);
  if (status == Status::ok && cloth) {
    for (const uint32_t v : vertices) cloth->pinned[v] = false;
  }
  return {status, expect, 0};
}

Outcome Run::set_forces(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const ModelCloth* cloth = pick_cloth(r, w, id);
  const uint32_t n = cloth ? cloth->vertices : 4;
  std::vector<weft::VertexForce> forces;
  for (uint32_t i = r.below(4); i > 0 && n > 0; --i) {
    forces.push_back({r.below(n), {number(r, -1, 1), r.real(-1, 1), r.real(-1, 1)}});
  }
  Expect expect = !cloth ? Expect::handle : is_extreme_ ? Expect::any : Expect::ok;
  weft::View<weft::VertexForce> view = forces;
  if (cloth && !forces.empty() && r.chance(0.2)) {
    expect = Expect::refusal;
    switch (r.below(3)) {
      case 0:
        forces.back().vertex = n + r.below(3);
        break;
      case 1:
        forces.front().force = r.bad_vector();
        break;
      default:
        view.data = nullptr;
    }
  }
  return {w.world.set_forces(id, view), expect, 0};
}

Outcome Run::set_gravity(Random& r, ModelWorld& w) {
  if (r.chance(0.2)) return {w.world.set_gravity(r.bad_vector()), Expect::refusal, 0};
  const weft::double3 gravity{0, r.chance(0.5) ? -9.81 : number(r, -10, 2), 0};
  return {w.world.set_gravity(gravity), Expect::ok, 0};
}

Outcome Run::set_wind(Random& r, ModelWorld& w) {
  weft::WindDesc d;
  d.velocity = {number(r, -5, 5), r.real(-2, 2), r.real(-5, 5)};
  if (r.chance(0.3)) d.air_density = std::fabs(number(r, 0, 2));
  if (r.chance(0.3)) d.normal = std::fabs(number(r, 0, 2));
  if (r.chance(0.3)) d.tangential = r.chance(0.3) ? 0 : r.real(0, 0.5);
  if (!r.chance(0.2)) return {w.world.set_wind(d), Expect::ok, 0};
  switch (r.below(3)) {
    case 0:
      d.velocity = r.bad_vector();
      break;
    case 1:
      d.air_density = r.chance(0.5) ? -1 : r.bad();
      break;
    default:
      d.tangential = r.chance(0.5) ? -1e-9 : r.bad();
  }
  return {w.world.set_wind(d), Expect::refusal, 0};
}

Outcome Run::clear_wind(Random&, ModelWorld& w) { return {w.world.clear_wind(), Expect::ok, 0}; }

Outcome Run::set_self_collision(Random& r, ModelWorld& w) {
  weft::SelfCollisionDesc d;
  d.search = weft::PairSearch(r.below(2));
  d.distance = std::fabs(number(r, 0.01, 0.15)) + 1e-9;
  if (r.chance(0.5)) d.friction = std::fabs(number(r, 0, 1));
  d.cell = std::fabs(number(r, 0.02, 0.4)) + 1e-9;
  d.shifts = weft::GridShifts(r.below(2));
  d.grids = d.shifts == weft::GridShifts::corner ? 1u << r.below(4) : r.from_to(1, 6);
  if (r.chance(0.3)) d.window = r.from_to(1, 5);
  if (r.chance(0.4)) d.skin = std::fabs(number(r, 0, 0.1));
  Expect expect = is_extreme_ ? Expect::any : Expect::ok;
  if (r.chance(0.2)) {
    expect = Expect::refusal;
    switch (r.below(7)) {
      case 0:
        d.search = weft::PairSearch(r.from_to(2, 255));
        break;
      case 1:
        d.distance = r.chance(0.5) ? 0 : r.bad();
        break;
      case 2:
        d.friction = r.chance(0.5) ? -1e-9 : r.bad();
        break;
      case 3:
        d.cell = r.chance(0.5) ? -1 : r.bad();
        break;
      case 4:
        d.grids = d.shifts == weft::GridShifts::corner ? 3 : 0;
        break;
      case 5:
        d.shifts = weft::GridShifts(r.from_to(2, 255));
        break;
      default:
        d.skin = r.bad();
    }
  }
  const Status status = w.world.set_self_collision(d);
  if (status == Status::ok) w.collides = true;
  return {status, expect, 0};
}

Outcome Run::clear_self_collision(Random&, ModelWorld& w) {
  const Status status = w.world.clear_self_collision();
  if (status == Status::ok) w.collides = false;
  return {status, Expect::ok, 0};
}

Outcome Run::wake(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const bool is_there = pick_cloth(r, w, id);
  const Status status = w.world.wake(id);
  if (status == Status::ok) {
    const weft::Result<bool> asleep = w.world.asleep(id);
    require(asleep && !*asleep, "asleep after wake");
  }
  return {status, is_there ? Expect::ok : Expect::handle, 0};
}

}  // namespace weft_tests::driver
