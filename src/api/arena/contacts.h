// What particles need to meet each other: the tables of the search, and the memory of its list.
#pragma once

#include "api/arena/arena.h"
#include "api/arena/device_memory.h"

namespace weft::api {

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
  /// Whether the list that was made last wants more room than it has; then it gets it.
  Status make_room(Simulation<T>&, bool& wanted);
  /// After a frame: which sleepers were touched.
  Status wake_touched(const ArenaInput&, const Simulation<T>&);
  /// The list is of no more use: where particles are has changed without a step.
  void forget_list() { age_ = -1; }
  void give_age(Frame<T>& frame) const {
    frame.list_age = age_;
    frame.list_since = since_;
  }
  void take_age(const Frame<T>& frame) {
    age_ = frame.list_age;
    since_ = frame.list_since;
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

  ContextState& context_;
  const Backend& backend_;
  DeviceMemory memory_;  ///< of the list
  Vector<ContactCloth> cloths_;
  Vector<unsigned long long> woken_;
  int age_ = -1, since_ = -1;
  uint64_t lists_ = 0, listed_ = 0, lists_before_ = 0;
};

}  // namespace weft::api
