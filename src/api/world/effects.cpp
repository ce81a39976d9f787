// What acts on the cloths of a world and changes between steps: gravity, forces, wind, moving
// colliders; and who sleeps through it.
#include <algorithm>
#include <cmath>

#include "api/world/call_guard.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"
#include "scene/check.h"

namespace weft {
inline namespace v0 {

void World::Impl::wake_all() noexcept {
  for (const ClothId id : order) api::wake(*cloths[id.index]);
}

void World::Impl::wake_touched(const api::ColliderRecord& collider, double dt) {
  const api::ColliderPath path = path_of(collider, time, dt);
  const api::SweptBounds bounds = swept_bounds(collider, path);
  for (const ClothId id : order) {
    api::ClothRecord& cloth = *cloths[id.index];
    if (!cloth.asleep || !may_meet(cloth, collider)) continue;
    // A hair's breadth more than the bounds: what rests on a collider is at its surface.
    const double hair = 1e-3 * api::length(api::minus(cloth.high, cloth.low)) + 1e-6;
    const double3 by{hair, hair, hair};
    const double3 low = api::minus(api::plus(cloth.low, cloth.origin), by);
    const double3 high = api::plus(api::plus(cloth.high, cloth.origin), by);
    if (api::comes_into(low, high, cloth.origin, collider, path, bounds, dt)) api::wake(cloth);
  }
}

void World::Impl::wake_neighbours(const api::ClothRecord& cloth, double way) {
  if (!self_collision) return;
  for (const ClothId id : order) {
    api::ClothRecord& other = *cloths[id.index];
    if (!other.asleep || &other == &cloth || !cloth.collides_others || !other.collides_others ||
        (cloth.collision_layers & other.collision_layers) == 0) {
      continue;
    }
    // What rests on a cloth is at its distance: a hair more.
    const double reach = 1.01 * 0.5 *
                             (api::collision_distance_of(cloth, *self_collision) +
                              api::collision_distance_of(other, *self_collision)) +
                         way;
    const double3 by{reach, reach, reach};
    const double3 low = api::minus(api::plus(cloth.low, cloth.origin), by);
    const double3 high = api::plus(api::plus(cloth.high, cloth.origin), by);
    const double3 from = api::plus(other.low, other.origin);
    const double3 to = api::plus(other.high, other.origin);
    if (from.x <= high.x && from.y <= high.y && from.z <= high.z && to.x >= low.x &&
        to.y >= low.y && to.z >= low.z) {
      api::wake(other);
      wake_neighbours(other, 0);  // what rests on that too
    }
  }
}

void World::Impl::wake_by_cloths(double substep) {
  if (!self_collision) return;
  for (const ClothId id : order) {
    const api::ClothRecord& cloth = *cloths[id.index];
    if (cloth.asleep) continue;
    bool moves = cloth.pins_led;
    for (const ClothId of : order) {
      const api::ClothRecord& other = *cloths[of.index];
      moves |= other.asleep && cloth.furthest >= other.sleep_speed * substep;
    }
    // Where it was a frame ago counts too.
    if (moves) wake_neighbours(cloth, cloth.furthest * substeps_last);
  }
}

void World::Impl::wake_by_colliders(double dt) {
  bool any = false;
  for (const ClothId id : order) any |= cloths[id.index]->asleep;
  if (!any) return;
  for (const api::ColliderRecord& c : colliders) {
    if (c.id && path_of(c, time, dt).moves) wake_touched(c, dt);
  }
}

Status World::set_gravity(double3 gravity) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  return api::guarded(*impl_->context, [&] {
    api::checked_vector(gravity, "gravity");
    if (api::same(gravity, impl_->desc.gravity)) return Status::ok;
    impl_->desc.gravity = gravity;
    impl_->forget_results();
    impl_->dirty |= impl_->starting;  // the start displacements depend on it
    impl_->wake_all();
    return Status::ok;
  });
}

Status World::set_forces(ClothId id, View<VertexForce> forces) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  return api::guarded(*impl_->context, [&] {
    std::pmr::vector<VertexForce> sorted(&impl_->context->memory);
    api::checked_forces(forces, cloth->cooked().vertices, sorted);
    const auto same_force = [](const VertexForce& a, const VertexForce& b) {
      return a.vertex == b.vertex && api::same(a.force, b.force);
    };
    if (std::equal(sorted.begin(), sorted.end(), cloth->forces.begin(), cloth->forces.end(),
                   same_force)) {
      return Status::ok;
    }
    impl_->dirty |= impl_->starting || sorted.empty() != cloth->forces.empty();
    cloth->forces = std::move(sorted);
    cloth->changed(Part::forces);
    impl_->forget_results();
    api::wake(*cloth);
    return Status::ok;
  });
}

static bool same_wind(const WindDesc& a, const WindDesc& b) {
  return api::same(a.velocity, b.velocity) && a.air_density == b.air_density &&
         a.normal == b.normal && a.tangential == b.tangential;
}

Status World::set_wind(const WindDesc& wind) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  return api::guarded(*impl_->context, [&] {
    api::checked_vector(wind.velocity, "wind.velocity");
    scene::check_not_negative(wind.air_density, "wind.air_density");
    scene::check_not_negative(wind.normal, "wind.normal");
    scene::check_not_negative(wind.tangential, "wind.tangential");
    // Without air, or without any hold on it, there is no effect.
    if (wind.air_density == 0 || (wind.normal == 0 && wind.tangential == 0)) return clear_wind();
    if (impl_->wind && same_wind(*impl_->wind, wind)) return Status::ok;
    for (const ClothId id : impl_->order) {
      if (!impl_->wind) impl_->say_if_windless(*impl_->find(id));
    }
    impl_->dirty |= impl_->starting || !impl_->wind;
    impl_->wind = wind;
    impl_->forget_results();
    for (const ClothId id : impl_->order) impl_->find(id)->bound_known = false;
    impl_->wake_all();
    return Status::ok;
  });
}

Status World::clear_wind() noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  if (!impl_->wind) return Status::ok;
  return api::guarded(*impl_->context, [&] {
    impl_->wind.reset();
    impl_->dirty = true;
    impl_->forget_results();
    for (const ClothId id : impl_->order) impl_->find(id)->bound_known = false;
    impl_->wake_all();
    return Status::ok;
  });
}

void World::Impl::say_if_windless(const api::ClothRecord& cloth) {
  if (scene::triangle_count(cloth.cooked()) > 0 || cloth.cooked().vertices == 0) return;
  context->say(
      Severity::warning,
      text("cloth %u feels no wind (it has no triangles) use a grid or a mesh, or leave out "
           "the wind",
           cloth.id.index));
}

void World::Impl::move(api::ColliderRecord& c, const api::Placed& to, Move how) {
  const api::Placed from = api::placed_at(c, time);
  const api::Placed set_out = api::placed_at(c, time + time_owed);  // when the last frame ended
  using State = api::Way<api::Placed>::State;
  if (how == Move::simulate && api::same(c.velocity, {0, 0, 0})) {
    const api::Placed& goal = c.way.state == State::none ? from : c.way.to;
    if (api::same_place(goal, to)) return;
  }
  probed = false;
  if (how == Move::teleport && !api::same_place(from, to)) wake_touched(c, 0);
  if (!api::same(c.velocity, {0, 0, 0}) && frame_dt > 0) {
    c.was = api::placed_at(c, time - frame_dt);
    c.went = true;
  }
  c.placed = from;
  c.velocity = {0, 0, 0};
  c.since = time;
  if (how == Move::teleport) {
    c.placed = to;
    c.went = false;
    c.gliding = false;
    c.way.arrive();
    if (!api::same_place(from, to)) wake_touched(c, 0);
    return;
  }
  c.way.give(set_out, to);
  if (!c.can_turn && !api::same_rotation(c.placed, to)) c.can_turn = dirty = true;
}

Status World::move_collider(ColliderId id, const Pose& pose, Move how) noexcept {
  const api::CallGuard guard(impl_);
  if (!guard) return guard.status();
  api::ColliderRecord* c = impl_->find(id);
  if (!c) return impl_->stale("collider", id.index);
  return api::guarded(*impl_->context, [&] {
    scene::check_choice(int(how), 2, "how", "simulate, teleport");
    impl_->move(*c, api::after(api::placed_by(pose, "pose"), c->described), how);
    return Status::ok;
  });
}

Status World::wake(ClothId id) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  if (cloth->asleep) impl_->probed = false;
  api::wake(*cloth);
  return Status::ok;
}

Result<bool> World::asleep(ClothId id) noexcept {
  const api::CallGuard guard(impl_, id);
  if (!guard) return guard.status();
  const api::ClothRecord* cloth = impl_->find(id);
  if (!cloth) return impl_->stale("cloth", id.index);
  return cloth->asleep;
}

}  // namespace v0
}  // namespace weft
