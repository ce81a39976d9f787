#include "run.h"

#include "reference/world_helpers.h"

#include <algorithm>

namespace weft_tests::driver {

using weft::Status;

const std::vector<Run::Call>& Run::calls() {
  static const std::vector<Call> table = {
      {"cook grid", 4, &Run::cook_grid, in_any_flight},
      {"cook mesh", 4, &Run::cook_mesh, in_any_flight},
      {"cook network", 3, &Run::cook_network, in_any_flight},
      {"cook collider mesh", 3, &Run::cook_collider, in_any_flight},
      {"read fabric", 3, &Run::read_fabric, in_any_flight},
      {"drop fabric", 2, &Run::drop_fabric, in_any_flight | not_starved},
      {"create context", 1, &Run::bad_context, in_any_flight | not_starved},
      {"create_world", 3, &Run::create_world, in_any_flight},
      {"destroy world", 1, &Run::destroy_world, in_any_flight | not_starved},
      {"create_cloth", 10, &Run::create_cloth, plain},
      {"destroy_cloth", 3, &Run::destroy_cloth, plain},
      {"create collider", 7, &Run::create_collider, plain},
      {"destroy_collider", 3, &Run::destroy_collider, plain},
      {"move_collider", 7, &Run::move_collider, plain},
      {"create_collider_set", 3, &Run::create_set, plain},
      {"move_collider_set", 7, &Run::move_set, plain},
      {"destroy_collider_set", 1, &Run::destroy_set, plain},
      {"move_pins", 7, &Run::move_pins, plain},
      {"set_skinned_targets", 4, &Run::set_skinned_targets, plain},
      {"release_pins", 3, &Run::release_pins, plain},
      {"set_forces", 4, &Run::set_forces, plain},
      {"set_gravity", 2, &Run::set_gravity, plain},
      {"set_wind", 3, &Run::set_wind, plain},
      {"clear_wind", 1, &Run::clear_wind, plain},
      {"set_self_collision", 4, &Run::set_self_collision, plain},
      {"clear_self_collision", 1, &Run::clear_self_collision, plain},
      {"wake", 2, &Run::wake, plain},
      {"step", 22, &Run::step, time_passes},
      {"advance", 14, &Run::advance, time_passes | not_starved | not_left_out},
      {"begin_step", 8, &Run::begin_step, time_passes},
      {"end_step", 6, &Run::end_step, time_passes | in_any_flight | not_starved},
      {"prepare", 3, &Run::prepare, plain},
      {"substeps", 2, &Run::substeps, plain},
      {"read points", 6, &Run::read_points, plain},
      {"read vectors", 4, &Run::read_vectors, plain},
      {"mechanics, plan, stability", 5, &Run::read_sums, plain},
      {"contacts, near_pairs", 4, &Run::read_pairs, plain},
      {"ask at any time", 4, &Run::ask_any_time, in_any_flight},
      {"ask about a cloth", 4, &Run::ask_about_cloth, plain},
      {"debug_draw", 3, &Run::debug_draw, plain},
      {"bind_output", 6, &Run::bind_output, plain},
      {"unbind_output", 2, &Run::unbind_output, plain},
      {"set_output_memory", 3, &Run::set_output_memory, plain},
      {"write_outputs", 8, &Run::write_outputs, writes},
  };
  return table;
}

Run::Run(uint64_t seed, const Way& way) : seed_(seed), way_(way) {
  is_extreme_ = Random(seed, ~0u).chance(0.3);
  for (std::unique_ptr<Home>& home : homes_) {
    home = std::make_unique<Home>();
    make_home(*home);
  }
}

Run::~Run() {
  for (const auto& home : homes_) home->heap.left = Heap::endless;
}

void Run::make_home(Home& home) {
  weft::ContextDesc desc;
  desc.backend = tested_backend();
  desc.threads = way_.threads;
  desc.allocator = home.heap.hooks();
  desc.log = book_.hooks();
  if (way_.jobs) desc.jobs = pool_.hooks();
  weft::Result<weft::Context> made = weft::Context::create(desc);
  require(bool(made), "no context: %s", weft::to_string(made.status()));
  home.context = std::move(*made);
  home.bytes_alone = home.context.bytes_allocated();
}

/// Its numbers depend on no call, as calls may be left out.
void Run::make_first_world() {
  Random random(seed_, (uint64_t(1) << 32) + first_worlds_++);
  auto first = std::make_unique<ModelWorld>();
  first->home = random.below(2);
  first->desc = world_desc(random);
  const weft::double3 places[] = {{0, 0, 0}, {0, 0, 0}, {5000.3, -7, 12}, {-3, 800, -5000}};
  first->at = random.one_of(places);
  weft::Result<weft::World> made = home_of(*first).context.create_world(first->desc);
  require(bool(made), "create_world: %s", book_.last.c_str());
  first->world = std::move(*made);
  worlds_.push_back(std::move(first));
}

void Run::leave_out(uint32_t) { trace_.emplace_back(); }

void Run::call(uint32_t number) {
  Random random(seed_, number);
  if (worlds_.empty()) make_first_world();
  ModelWorld& w = *worlds_[random.below(worlds_.size())];
  uint32_t sum = 0;
  for (const Call& c : calls()) sum += c.weight;
  uint32_t at = random.below(sum);
  const Call* chosen = calls().data();
  while (at >= chosen->weight) at -= (chosen++)->weight;
  // A flight ends soon.
  if (w.in_flight && random.chance(0.3)) {
    for (const Call& c : calls()) {
      if (c.make == &Run::end_step) chosen = &c;
    }
  }
  told_.push_back(printed("%4u  %s, world %u", number, chosen->name, w.number));
  if (way_.says) std::fprintf(stderr, "%s: %s\n", way_.name, told_.back().c_str());

  remember_places(w);
  const bool was_known = w.is_known, was_in_flight = w.in_flight;
  const Seen before = w.seen;
  const double dropped = w.world.stats().time_dropped, time = w.world.time();
  book_.clear();
  Outcome outcome = way_.starved && !(chosen->traits & not_starved)
                        ? make_starved(*chosen, random, w)
                        : make(*chosen, random, w);
  told_.back() += printed(": %s", weft::to_string(outcome.status));
  if (way_.says) std::fprintf(stderr, "      %s\n", weft::to_string(outcome.status));
  Entry entry{chosen->name, outcome.status, outcome.result, 0};
  if (destroys_world_) {
    destroys_world_ = false;
    for (auto& world : worlds_) {
      if (world.get() == &w) std::swap(world, worlds_.back());
    }
    worlds_.pop_back();
  } else {
    require(w.world.time() >= time, "time went from %.17g to %.17g s", time, w.world.time());
    if (!way_.quiet || number % 8 == 7) {
      check(*chosen, outcome, w, before, was_known, was_in_flight);
      entry.seen = w.seen.digest();
    } else {
      w.is_known = false;
    }
    check_events(w, *chosen, outcome, dropped);
  }
  if (new_world_) {
    new_world_->number = number;
    worlds_.push_back(std::move(new_world_));
  }
  check_memory();
  trace_.push_back(entry);
}

Outcome Run::make(const Call& call, Random random, ModelWorld& w) {
  const bool was_in_flight = w.in_flight;
  Outcome outcome = (this->*call.make)(random, w);
  if (was_in_flight && !(call.traits & in_any_flight)) {
    require(outcome.status == Status::in_flight, "%s in a flight answers %s", call.name,
            weft::to_string(outcome.status));
    outcome.expect = Expect::any;
  }
  const bool failed = outcome.status != Status::ok;
  // What is said again and again is told rarely.
  require(failed || book_.errors == 0, "%s answers ok, and the log was told of an error: %s",
          call.name, book_.last.c_str());
  if (book_.errors > 0 && book_.last.find(" (") == std::string::npos) {
    throw Finding("a message without its reason: " + book_.last);
  }
  return outcome;
}

Outcome Run::make_starved(const Call& call, const Random& random, ModelWorld& w) {
  Heap& heap = home_of(w).heap;
  Random countdown = random;
  countdown.next();
  const uint32_t given = countdown.below(12);
  const double time = w.world.time();
  const size_t clothes = w.cloths.size();
  for (heap.left = given;; heap.left = Heap::endless) {
    const bool is_starved = heap.left != Heap::endless;
    book_.clear();
    const Outcome outcome = make(call, random, w);
    heap.left = Heap::endless;
    if (!is_starved || outcome.status != Status::out_of_memory) return outcome;
    told_.back() += printed(" (no memory after %u blocks)", given);
    require(w.world.time() == time, "time passed while memory ran out");
    require(w.cloths.size() == clothes && !new_world_, "out of memory, but something was made");
  }
}

/// Before a cloth's first step its velocities depend on how long a step was prepared, by rounding,
/// and the accelerations of the others, too.
bool Run::all_have_moved(const ModelWorld& w) {
  const uint64_t frames = w.world.stats().frames;
  return std::all_of(w.cloths.begin(), w.cloths.end(),
                     [&](const ModelCloth& cloth) { return cloth.born < frames; });
}

uint64_t Run::look_at(ModelWorld& w, ModelCloth& cloth) {
  Digest digest;
  std::vector<weft::double3> x(cloth.vertices), v(cloth.vertices);
  const Status read = w.world.read_positions(cloth.id, x.data());
  require(read == Status::ok, "read_positions: %s", weft::to_string(read));
  digest.add(x.data(), x.size() * sizeof x[0]);
  cloth.seen_positions = digest.value();
  check_bounds(w, cloth, x);
  if (all_have_moved(w)) {
    digest.add(int(w.world.read_velocities(cloth.id, v.data())));
    digest.add(v.data(), v.size() * sizeof v[0]);
  }
  const weft::Result<bool> asleep = w.world.asleep(cloth.id);
  require(bool(asleep), "asleep of a cloth that is there");
  cloth.seen_asleep = *asleep;
  digest.add(uint32_t(*asleep));
  return digest.value();
}

void Run::check_bounds(ModelWorld& w, const ModelCloth& cloth,
                       const std::vector<weft::double3>& x) {
  const weft::Result<weft::Bounds> bounds = w.world.bounds(cloth.id);
  require(bool(bounds), "bounds of a cloth that is there");
  const weft::double3 &low = bounds->low, &high = bounds->high;
  if (x.empty()) return require(low.x > high.x, "bounds of no vertices");
  for (const weft::double3& p : x) {
    if (!std::isfinite(p.x + p.y + p.z)) return;
  }
  for (size_t i = 0; i < x.size(); ++i) {
    const weft::double3& p = x[i];
    require(p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y &&
                p.z <= high.z,
            "vertex %zu at (%.17g, %.17g, %.17g) is outside of its bounds (%.17g, %.17g, %.17g) to "
            "(%.17g, %.17g, %.17g)",
            i, p.x, p.y, p.z, low.x, low.y, low.z, high.x, high.y, high.z);
  }
}

Seen Run::look(ModelWorld& w) {
  Seen seen;
  const weft::Stats stats = w.world.stats();
  seen.time = w.world.time();
  seen.dropped = stats.time_dropped;
  seen.frames = stats.frames;
  seen.steps = stats.steps;
  seen.particles = stats.particles;
  seen.springs = stats.springs;
  Digest bounds, state;
  uint64_t particles = 0;
  for (ModelCloth& cloth : w.cloths) {
    require(w.world.valid(cloth.id), "a cloth that is there is not valid");
    const weft::Result<weft::Bounds> b = w.world.bounds(cloth.id);
    require(bool(b), "bounds of a cloth that is there");
    bounds.add(b->low);
    bounds.add(b->high);
    particles += cloth.vertices;
    if (!w.in_flight) state.add(look_at(w, cloth));
  }
  require(particles == seen.particles, "stats count %llu particles, there are %llu",
          static_cast<unsigned long long>(seen.particles),
          static_cast<unsigned long long>(particles));
  for (const weft::ClothId dead : w.dead_cloths) {
    require(!w.world.valid(dead), "a destroyed cloth is valid");
  }
  seen.bounds = bounds.value();
  if (w.in_flight) return seen;
  const weft::Result<uint64_t> hash = w.world.state_hash();
  require(bool(hash), "state_hash: %s", weft::to_string(hash.status()));
  state.add(*hash);
  seen.state = state.value();
  return seen;
}

void Run::check(const Call& call, const Outcome& outcome, ModelWorld& w, const Seen& before,
                bool was_known, bool was_in_flight) {
  const Status status = outcome.status;
  if (outcome.expect == Expect::ok) {
    require(status == Status::ok, "good arguments are refused: %s", book_.last.c_str());
  } else if (outcome.expect == Expect::refusal) {
    require(status == Status::invalid_argument, "bad arguments answer %s", weft::to_string(status));
  } else if (outcome.expect == Expect::handle) {
    require(status == Status::invalid_handle, "an id that names nothing answers %s",
            weft::to_string(status));
  }
  w.seen = look(w);
  w.is_known = true;
  check_places(w, call);
  if (!was_known || was_in_flight != w.in_flight || status == Status::ok) return;
  if (status == Status::diverged && (call.traits & time_passes)) return;
  const auto same = [](double a, double b) { return same_bits(a, b); };
  require(same(w.seen.time, before.time), "a failing call moved time");
  require(same(w.seen.dropped, before.dropped), "a failing call dropped time");
  require(w.seen.frames == before.frames && w.seen.steps == before.steps,
          "a failing call counts as a step");
  require(w.seen.particles == before.particles && w.seen.springs == before.springs,
          "a failing call changed a count");
  require(w.seen.bounds == before.bounds, "a failing call changed bounds");
  require(w.seen.state == before.state, "a failing call changed the state");
}

}  // namespace weft_tests::driver
