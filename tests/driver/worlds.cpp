// Contexts, worlds and cloths.
#include "run.h"

#include <algorithm>

namespace weft_tests::driver {

using weft::Status;

Outcome Run::bad_context(Random& r, ModelWorld& w) {
  weft::ContextDesc desc;
  desc.log = book_.hooks();
  Status wanted = Status::invalid_argument;
  uint32_t abi = WEFT_ABI;
  switch (r.below(8)) {
    case 0:
      abi += r.from_to(1, 9);
      wanted = Status::version_mismatch;
      break;
    case 1:
      desc.threads = 1025 + r.below(1000);
      break;
    case 2:
      desc.isa = weft::Isa(r.from_to(4, 255));
      break;
    case 3:
      desc.backend = weft::BackendKind(r.from_to(4, 255));
      break;
    case 4:
      desc.allocator = home_of(w).heap.hooks();
      desc.allocator.deallocate = nullptr;
      break;
    case 5:
      desc.jobs = pool_.hooks();
      desc.jobs.workers = r.chance(0.5) ? 0 : 5000;
      break;
    case 6:
      desc.profiler.zone_end = [](void*, void*) {};
      break;
    default: {
      weft::Context empty;
      require(empty.create_world().status() == Status::invalid_handle, "a world of no context");
      require(empty.cook(weft::GridDesc()).status() == Status::invalid_handle,
              "a fabric of no context");
      require(empty.bytes_allocated() == 0 && empty.info().threads == 0, "of no context");
      const weft::ContextInfo info = home_of(w).context.info();
      require(info.backend && info.device && info.isa && info.threads > 0, "no information");
      return {};
    }
  }
  const Status status = weft::Context::create(desc, abi).status();
  require(status == wanted, "a bad context answers %s", weft::to_string(status));
  return {status, Expect::any, 0};
}

weft::WorldDesc Run::world_desc(Random& r) const {
  weft::WorldDesc d;
  d.gravity = r.chance(0.8) ? weft::double3{0, -9.81, 0} : r.vector(5);
  d.precision = weft::Precision(r.below(2));
  d.form = weft::Form(r.below(2));
  d.start = weft::Start(r.below(2));
  if (r.chance(0.2)) d.substeps = r.from_to(1, 30);
  if (r.chance(0.4)) d.max_substeps = d.substeps + r.from_to(1, 30);
  if (r.chance(0.2)) d.safety = r.real(0.3, 1);
  d.unsafe = r.chance(0.1);
  d.fixed_dt = r.one_of({1.0 / 60, 1.0 / 60, 1.0 / 120, 1.0 / 30, 0.01});
  d.max_steps_per_advance = r.from_to(1, 4);
  d.interpolate = r.chance(0.5);
  if (r.chance(0.4)) d.evaluation = weft::Evaluation(r.below(3));
  if (d.evaluation == weft::Evaluation::scatter && r.chance(0.6)) {
    d.accumulate =
        r.one_of({weft::Accumulate::fixed64, weft::Accumulate::float16, weft::Accumulate::float24,
                  weft::Accumulate::float24_all, weft::Accumulate::fixed8});
    d.fixed8_range = r.real(0.5, 2);
  }
  d.profile = r.chance(0.2);
  if (r.chance(0.35)) {
    d.integrator = weft::Integrator::xpbd;
    d.form = weft::Form::summed;
    d.evaluation = weft::Evaluation::automatic;
    d.accumulate = weft::Accumulate::native;
  }
  if (r.chance(0.3)) {
    d.ladder[0] = uint8_t(r.from_to(3, 9));
    d.ladder[1] = 2;
  }
  return d;
}

Outcome Run::create_world(Random& r, ModelWorld& w) {
  auto made = std::make_unique<ModelWorld>();
  made->home = w.home;
  made->desc = world_desc(r);
  if (r.chance(0.4)) made->at = {5000 * r.real(-1, 1), 100 * r.real(-1, 1), 5000 * r.real(-1, 1)};
  weft::WorldDesc& d = made->desc;
  Expect expect = worlds_.size() < 4 ? Expect::ok : Expect::refusal;
  if (expect == Expect::refusal || r.chance(0.3)) {
    expect = Expect::refusal;
    switch (r.below(9)) {
      case 0:
        d.gravity = r.bad_vector();
        break;
      case 1:
        d.safety = r.chance(0.5) ? 0 : 1.5;
        break;
      case 2:
        d.fixed_dt = r.chance(0.5) ? 0 : -std::fabs(r.bad());
        break;
      case 3:
        d.max_steps_per_advance = 0;
        break;
      case 4:
        d.evaluation = weft::Evaluation::gather;
        d.accumulate = weft::Accumulate::fixed64;
        break;
      case 5:
        d.substeps = 9;
        d.max_substeps = 8;
        break;
      case 6:
        d.precision = weft::Precision(r.from_to(2, 255));
        break;
      case 7:
        d.fixed8_range = r.chance(0.5) ? 0 : std::numeric_limits<double>::quiet_NaN();
        break;
      default:
        d.form = weft::Form(r.from_to(2, 255));
    }
  }
  weft::Result<weft::World> world = home_of(w).context.create_world(d);
  if (world) {
    made->world = std::move(*world);
    new_world_ = std::move(made);
  }
  return {world.status(), expect, 0};
}

Outcome Run::destroy_world(Random& r, ModelWorld& w) {
  if (r.chance(0.5)) {  // moved, it stays itself
    weft::World other = std::move(w.world);
    require(w.world.step(0.01) == Status::invalid_handle, "a world that was moved away");
    require(!w.world.valid({0, 1}) && w.world.time() == 0, "a world that was moved away");
    w.world = std::move(other);
    return {};
  }
  w.world = weft::World();
  destroys_world_ = true;
  return {};
}

Outcome Run::create_cloth(Random& r, ModelWorld& w) {
  if (w.cloths.size() >= 4 && !w.in_flight) return destroy_cloth(r, w);
  weft::ClothDesc d;
  Home& home = *homes_[r.chance(0.9) ? w.home : 1 - w.home];
  if (!home.fabrics.empty()) d.fabric = home.fabrics[r.below(home.fabrics.size())];
  ModelCloth cloth;
  cloth.vertices = d.fabric.vertex_count();
  cloth.render_vertices = d.fabric.render_vertex_count();
  cloth.pinned.assign(cloth.vertices, false);
  Expect expect = !d.fabric.impl() ? Expect::refusal : is_extreme_ ? Expect::any : Expect::ok;
  d.pose = pose(r, w.at);
  std::vector<weft::double3> x, v;
  Points points;
  if (cloth.vertices > 0 && r.chance(0.2)) {
    for (uint32_t i = 0; i < cloth.vertices; ++i) x.push_back(place(r, w, 0.6));
    points = stored(r, x);
    d.positions = points.view;
  }
  if (r.chance(0.3)) d.velocity = r.vector(2);
  if (r.chance(0.2)) {
    for (uint32_t i = 0; i < cloth.vertices; ++i) v.push_back(r.vector(1));
    d.velocities = v;
  }
  std::vector<weft::PinMotion> motions(r.below(3));
  for (weft::PinMotion& m : motions) {
    m.velocity = r.vector(0.5);
    m.amplitude = r.vector(0.2);
    m.omega = number(r, -10, 10);
  }
  std::vector<weft::Pin> pins;
  for (uint32_t i = 0; i < cloth.vertices; ++i) {
    if (!r.chance(0.1)) continue;
    pins.push_back(
        {i, r.chance(0.3) && !motions.empty() ? r.below(motions.size()) : weft::Pin::fixed});
    cloth.pinned[i] = true;
    cloth.has_motions |= pins.back().motion != weft::Pin::fixed;
  }
  std::vector<weft::VertexForce> forces;
  for (uint32_t i = 0; cloth.vertices > 0 && i < r.below(3); ++i) {
    forces.push_back({r.below(cloth.vertices), r.vector(0.5)});
  }
  d.drag = r.chance(0.5) ? 0 : std::fabs(number(r, 0, 0.5));
  d.spring_damping = r.chance(0.5) ? 0 : std::fabs(number(r, 0, 0.2));
  d.sleep_speed = r.chance(0.4) ? 0 : r.real(0.01, 3);
  d.sleep_time = r.chance(0.5) ? 0 : r.real(0, 0.1);
  d.tether_scale = r.chance(0.7) ? 0 : r.real(0.8, 1.5);
  d.tether_compliance = r.chance(0.5) ? 0 : r.real(0, 0.01);
  d.drag_model = weft::DragModel(r.below(2));
  d.collision_distance = r.chance(0.6) ? 0 : std::fabs(number(r, 0.01, 0.1));
  d.collides_itself = r.chance(0.9) ? 1 : 0;
  d.collides_others = r.chance(0.9) ? 1 : 0;
  if (r.chance(0.3)) d.collision_layers = r.below(8);
  if (expect != Expect::refusal && r.chance(0.15)) {
    expect = Expect::refusal;
    const uint32_t n = cloth.vertices;
    switch (r.below(9)) {
      case 0: {
        const weft::ClothNumber& number =
            weft::cloth_numbers[r.below(std::size(weft::cloth_numbers))];
        d.*number.value = r.chance(0.5) ? -1e-9 : r.bad();
        break;
      }
      case 1:
        if (r.chance(0.5)) {
          d.drag_model = weft::DragModel(r.from_to(2, 255));
        } else {
          d.collides_others = static_cast<uint8_t>(r.from_to(2, 255));
        }
        break;
      case 2:
        pins.push_back({n + r.below(4), weft::Pin::fixed});
        break;
      case 3:
        pins.assign(2, {0, weft::Pin::fixed});
        break;
      case 4:
        pins.assign(1, {0, static_cast<uint32_t>(motions.size()) + r.below(3)});
        break;
      case 5:
        x.assign(n + 1, {0, 0, 0});
        points = stored(r, x);
        d.positions = points.view;
        break;
      case 6:
        d.velocity = r.bad_vector();
        break;
      case 7:
        forces.push_back({0, r.bad_vector()});
        break;
      default:
        d.pose.degrees = 90;
        d.pose.axis = r.chance(0.5) ? weft::double3{0, 0, 0} : r.bad_vector();
    }
  }
  d.motions = motions;
  d.pins = pins;
  d.forces = forces;
  const weft::Result<weft::ClothId> made = w.world.create_cloth(d);
  if (!made) return {made.status(), expect, 0};
  cloth.id = *made;
  cloth.born = w.world.stats().frames;
  remember(cloths_given_, cloth.id);
  w.cloths.push_back(std::move(cloth));
  return {Status::ok, expect, 0};
}

Outcome Run::destroy_cloth(Random& r, ModelWorld& w) {
  weft::ClothId id;
  const bool is_there = pick_cloth(r, w, id);
  const Status status = w.world.destroy_cloth(id);
  if (status != Status::ok) return {status, is_there ? Expect::ok : Expect::handle, 0};
  for (const ModelOutput& output : w.outputs) {
    if (output.cloth == id) w.dead_outputs.push_back(output.id);
  }
  w.outputs.erase(std::remove_if(w.outputs.begin(), w.outputs.end(),
                                 [&](const ModelOutput& o) { return o.cloth == id; }),
                  w.outputs.end());
  w.cloths.erase(std::find_if(w.cloths.begin(), w.cloths.end(),
                              [&](const ModelCloth& c) { return c.id == id; }));
  w.dead_cloths.push_back(id);
  return {status, Expect::ok, 0};
}

}  // namespace weft_tests::driver
