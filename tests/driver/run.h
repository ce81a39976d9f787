// A run: a row of calls that its seed decides, made in one of several ways which must all give the
// same trace.
#pragma once

#include "model.h"
#include "services.h"

#include <array>
#include <functional>
#include <set>
#include <utility>

namespace weft_tests::driver {

/// How the calls of a run are made.
struct Way {
  const char* name = "";
  uint32_t threads = 1;
  bool jobs = false;     ///< the caller's threads
  bool starved = false;  ///< each call is first made with memory for a part of it
  bool quiet = false;    ///< nothing is looked at but after every eighth call
  bool says = false;     ///< prints each call before it is made
};

enum class Expect : uint8_t {
  any,
  ok,
  refusal,  ///< invalid_argument
  handle,   ///< invalid_handle
};
struct Outcome {
  weft::Status status = weft::Status::ok;
  Expect expect = Expect::any;
  uint64_t result = 0;  ///< digest of what the call gave
};

/// What a call of the table may do.
enum Traits : uint32_t {
  plain = 0,
  time_passes = 1,    ///< of the family of step
  in_any_flight = 2,  ///< also while a step is in flight
  writes = 4,         ///< to the memory of outputs
  not_starved = 8,    ///< is not made again where memory ran out
  not_left_out = 16,  ///< changes something where it fails, as documented
};

struct Entry {
  const char* name = nullptr;  ///< null: left out
  weft::Status status = weft::Status::ok;
  uint64_t result = 0;
  uint64_t seen = 0;  ///< 0: nobody looked
};

class Run {
 public:
  Run(uint64_t seed, const Way& way);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Throws Finding.
  void call(uint32_t number);
  void leave_out(uint32_t number);
  /// Everything is destroyed; nothing may be left of it.
  void finish();
  const std::vector<Entry>& trace() const { return trace_; }
  /// The last calls, a line each.
  std::string last_calls(size_t count) const;

 private:
  struct Call {
    const char* name;
    uint32_t weight;
    Outcome (Run::*make)(Random&, ModelWorld&);
    uint32_t traits;
  };
  static const std::vector<Call>& calls();

  struct Home {  ///< a context and what was cooked in it
    Heap heap;
    weft::Context context;
    uint64_t bytes_alone = 0;  ///< of the context without anything
    std::vector<weft::Fabric> fabrics;
    std::vector<weft::ColliderMesh> meshes;
  };

  // run.cpp
  void make_home(Home&);
  void make_first_world();
  Outcome make(const Call&, Random, ModelWorld&);
  Outcome make_starved(const Call&, const Random&, ModelWorld&);
  Seen look(ModelWorld&);
  static bool all_have_moved(const ModelWorld&);
  uint64_t look_at(ModelWorld&, ModelCloth&);
  void check_bounds(ModelWorld&, const ModelCloth&, const std::vector<weft::double3>&);
  void check(const Call&, const Outcome&, ModelWorld&, const Seen& before, bool was_known,
             bool was_in_flight);
  void check_events(ModelWorld&, const Call&, const Outcome&, double dropped_before);
  void remember_places(const ModelWorld&);
  void check_places(const ModelWorld&, const Call&) const;
  void check_memory() const;
  /// An id that was never given before.
  template <class Id>
  static void remember(std::set<std::pair<uint32_t, uint32_t>>& given, Id id) {
    require(bool(id), "a null id was given");
    require(given.insert({id.index, id.generation}).second, "the id %u, %u was given twice",
            id.index, id.generation);
  }

  // Pieces of arguments: arguments.cpp.
  struct Points {
    std::vector<unsigned char> bytes;
    weft::PointView view;
  };
  static Points stored(Random&, const std::vector<weft::double3>&);
  static void spoil(Random&, Points&);
  double number(Random&, double low, double high) const;
  weft::double3 place(Random&, const ModelWorld&, double reach) const;
  weft::Pose pose(Random&, const weft::double3& about) const;
  weft::Material material(Random&, uint32_t vertices, std::vector<double>& masses) const;
  static void spoil(Random&, weft::Material&);
  static std::vector<weft::double3> sheet(Random&, uint32_t rows, uint32_t columns);
  static std::vector<uint32_t> triangles(uint32_t rows, uint32_t columns);
  weft::SphereDesc sphere(Random&, const ModelWorld&) const;
  weft::PlaneDesc plane(Random&, const ModelWorld&) const;
  weft::CapsuleDesc capsule(Random&, const ModelWorld&) const;
  weft::CylinderDesc cylinder(Random&, const ModelWorld&) const;
  weft::BoxDesc box(Random&, const ModelWorld&) const;
  ModelCloth* pick_cloth(Random&, ModelWorld&, weft::ClothId&);
  /// An id that names nothing: null, of what was destroyed, or near one that is there.
  template <class Id, class Model>
  static Id pick_other(Random& r, const std::vector<Id>& dead, const std::vector<Model>& alive) {
    const Id odd[] = {{}, {~0u, 1}, {1u << 20, ~0u}, {0, ~0u}};
    if (!dead.empty() && r.chance(0.6)) return dead[r.below(dead.size())];
    if (alive.empty() || r.chance(0.5)) return r.one_of(odd);
    Id id = id_of(alive[r.below(alive.size())]);
    if (++id.generation == 0) ++id.generation;
    return id;
  }
  template <class Id>
  static Id id_of(Id id) {
    return id;
  }
  static weft::ClothId id_of(const ModelCloth& m) { return m.id; }
  static weft::ColliderSetId id_of(const ModelSet& m) { return m.id; }
  static weft::OutputId id_of(const ModelOutput& m) { return m.id; }
  Home& home_of(const ModelWorld& w) { return *homes_[w.home]; }

  // cook.cpp
  Outcome cook_grid(Random&, ModelWorld&);
  Outcome cook_mesh(Random&, ModelWorld&);
  Outcome cook_network(Random&, ModelWorld&);
  Outcome cook_collider(Random&, ModelWorld&);
  Outcome read_fabric(Random&, ModelWorld&);
  Outcome drop_fabric(Random&, ModelWorld&);
  template <class Desc>
  Outcome cook(const Desc&, Expect, Home&);

  // worlds.cpp
  Outcome bad_context(Random&, ModelWorld&);
  Outcome create_world(Random&, ModelWorld&);
  Outcome destroy_world(Random&, ModelWorld&);
  Outcome create_cloth(Random&, ModelWorld&);
  Outcome destroy_cloth(Random&, ModelWorld&);
  weft::WorldDesc world_desc(Random&) const;

  // colliders.cpp
  Outcome create_collider(Random&, ModelWorld&);
  Outcome destroy_collider(Random&, ModelWorld&);
  Outcome move_collider(Random&, ModelWorld&);
  Outcome create_set(Random&, ModelWorld&);
  Outcome move_set(Random&, ModelWorld&);
  Outcome destroy_set(Random&, ModelWorld&);

  // inputs.cpp
  Outcome move_pins(Random&, ModelWorld&);
  Outcome set_skinned_targets(Random&, ModelWorld&);
  Outcome release_pins(Random&, ModelWorld&);
  Outcome set_forces(Random&, ModelWorld&);
  Outcome set_gravity(Random&, ModelWorld&);
  Outcome set_wind(Random&, ModelWorld&);
  Outcome clear_wind(Random&, ModelWorld&);
  Outcome set_self_collision(Random&, ModelWorld&);
  Outcome clear_self_collision(Random&, ModelWorld&);
  Outcome wake(Random&, ModelWorld&);

  // time.cpp
  Outcome step(Random&, ModelWorld&);
  Outcome advance(Random&, ModelWorld&);
  Outcome begin_step(Random&, ModelWorld&);
  Outcome end_step(Random&, ModelWorld&);
  Outcome prepare(Random&, ModelWorld&);
  Outcome substeps(Random&, ModelWorld&);
  double time_step(Random&, bool& is_bad) const;
  /// Whether a step is short enough to be made.
  static weft::Status afford(ModelWorld&, double dt, double steps);

  // reads.cpp
  Outcome read_points(Random&, ModelWorld&);
  Outcome read_vectors(Random&, ModelWorld&);
  Outcome read_sums(Random&, ModelWorld&);
  Outcome read_pairs(Random&, ModelWorld&);
  Outcome ask_any_time(Random&, ModelWorld&);
  Outcome ask_about_cloth(Random&, ModelWorld&);
  Outcome debug_draw(Random&, ModelWorld&);

  // outputs.cpp
  Outcome bind_output(Random&, ModelWorld&);
  Outcome unbind_output(Random&, ModelWorld&);
  Outcome set_output_memory(Random&, ModelWorld&);
  Outcome write_outputs(Random&, ModelWorld&);
  void check_written(ModelWorld&, ModelOutput&, double alpha);

  uint64_t seed_;
  Way way_;
  bool is_extreme_;  ///< values at the ends of what is allowed
  Book book_;
  Pool pool_;
  std::array<std::unique_ptr<Home>, 2> homes_;
  std::vector<std::unique_ptr<ModelWorld>> worlds_;
  std::unique_ptr<ModelWorld> new_world_;
  uint32_t first_worlds_ = 0;
  bool destroys_world_ = false;
  struct Place {
    weft::ClothId cloth;
    uint64_t positions;
    bool asleep;
  };
  std::vector<Place> places_;  ///< before the call
  std::set<std::pair<uint32_t, uint32_t>> cloths_given_, colliders_given_, sets_given_,
      outputs_given_;
  std::vector<Entry> trace_;
  std::vector<std::string> told_;
};

}  // namespace weft_tests::driver
