// What particles need to meet each other: the tables of the search, and the memory of its list.
#pragma once

#include "api/arena/arena.h"
#include "api/arena/device_memory.h"

namespace weft::api {

enum class FrameVerdict { done, to_go_on, to_make_again };

template <class T>
class ContactTables {
 public:
  explicit ContactTables(ContextState& context)
      : context_(context), backend_(*context.backend), memory_(context) {}

  /// Writes the tables to an image of the device memory.
  void fill(const ArenaInput&, Simulation<T>& image) const;
  /// What is no array, and room for a list, in a simulation whose device memory is new.
  Status prepare(const ArenaInput&, Simulation<T>&);
  /// Before a frame: the cloths as they are now.
  Status upload(const ArenaInput&, Simulation<T>&);
  /// Whether a list wants more room than it has; then it gets it.
  Status make_room(Simulation<T>&, bool& wanted);
  /// What is to be done after a call of Backend::frame; the room that a list wants is there then.
  Status judge(Frame<T>&, FrameVerdict&);
  /// After a frame: which sleepers were touched.
  Status wake_touched(const ArenaInput&, const Simulation<T>&);
  /// None, after all.
  Status forget_touched(const Simulation<T>&);
  /// The list is of no more use: where particles are has changed without a step.
  void forget_list() { age_ = groups_age_ = -1; }
  /// Nor is what it expects of particles.
  void forget_motion() { age_ = since_ = groups_age_ = -1; }
  void give_age(Frame<T>& frame) {
    const double longer = frame.dt - frame.dt_before;  // s: then they go on in another way
    if (frame.begin == 0 && longer * longer > 1e-4 * frame.dt * frame.dt) forget_motion();
    frame.list_age = age_;
    frame.list_since = since_;
    frame.list_for = made_for_;
    frame.groups_age = groups_age_;
    frame.contact_substep = substep_;
    frame.list_every = lists_last(frame) ? every_ : 0;
  }
  void take_age(const Frame<T>& frame) {
    age_ = frame.list_age;
    since_ = frame.list_since;
    made_for_ = frame.list_for;
    groups_age_ = frame.groups_age;
    substep_ = frame.contact_substep;
  }

  Status near_pairs(const ArenaInput&, const Simulation<T>&, const Vector<Vec3<T>>& positions,
                    bool with_excluded, Vector<NearPair>&);
  void counts(uint64_t& lists, uint64_t& listed) const {
    lists = lists_;
    listed = listed_;
  }
  uint64_t bytes() const { return memory_.data() ? memory_.bytes() : 0; }

 private:
  Status read_state(const Simulation<T>&, ContactState&);
  Status grow(Simulation<T>&, const ContactState&);
  void place_list(Contacts<T>&) const;
  bool lists_last(const Frame<T>& frame) const {
    const Contacts<T>& c = frame.sim.contacts;
    return c.search == Search::complete && c.skin > 0 && wait_ == 0 && !alone_;
  }
  void choose_shorter(const ContactState&);
  void choose_longer(const Frame<T>&, const ContactState&);

  static constexpr size_t entry_bytes = sizeof(int32_t) + sizeof(T);

  ContextState& context_;
  const Backend& backend_;
  DeviceMemory memory_;  ///< of the list
  Vector<ContactCloth> cloths_;
  Vector<unsigned long long> woken_;
  int age_ = -1, since_ = -1, groups_age_ = -1;
  uint64_t substep_ = 0;
  // Where the host cannot see within a frame (Team::sees).
  int made_for_ = 0;
  int every_ = 4;                ///< substeps that lists are made for
  int calm_ = 0, patience_ = 1;  ///< frames that no particle has outrun, and until longer is tried
  int wait_ = 0, backoff_ = 1;   ///< frames without such lists, and the next such time
  bool alone_ = false;           ///< the frame at hand is made again without
  uint64_t lists_ = 0, listed_ = 0, lists_before_ = 0;
};

}  // namespace weft::api
