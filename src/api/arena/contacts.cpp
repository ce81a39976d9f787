#include "api/arena/contacts.h"

#include <algorithm>
#include <cmath>

#include "api/arena/image.h"
#include "base/message_host.h"

namespace weft::api {

namespace {

double distance_of(const ClothRecord& cloth, const SelfCollisionDesc& desc) {
  return cloth.collision_distance > 0 ? cloth.collision_distance : desc.distance;
}

ContactCloth contact_cloth(const ClothRecord& cloth, const SelfCollisionDesc& desc) {
  return {{cloth.origin.x, cloth.origin.y, cloth.origin.z},
          distance_of(cloth, desc),
          cloth.sleep_speed,
          cloth.collision_layers,
          cloth.collides_itself ? 1 : 0,
          cloth.collides_others ? 1 : 0};
}

/// Whether two particles of these cloths may meet at all.
bool meet(const ContactCloth& a, const ContactCloth& b, bool same) {
  return same ? a.itself != 0 : a.others && b.others && (a.layers & b.layers) != 0;
}

// In distances: with more of each, lists hold more pairs; with less, they are made more often. The
// cost of a step changes by a tenth when one of them is doubled or halved.
constexpr double usual_skin = 0.2, most_stop = 0.3, most_drift = 2;

}  // namespace

template <class T>
void ContactTables<T>::fill(const ArenaInput& in, Simulation<T>& image) const {
  if (!in.self_collision || in.cloths.empty()) return;
  uint32_t* rank = writable(image.contacts.rank);
  double* rest = writable(image.contacts.rest);
  // By creation: what is added to a world later does not come before what is there.
  Vector<const ClothRecord*> created(in.cloths.begin(), in.cloths.end());
  std::sort(created.begin(), created.end(),
            [](const ClothRecord* a, const ClothRecord* b) { return a->created < b->created; });
  uint32_t next = 0;
  for (const ClothRecord* cloth : created) {
    const scene::CookedFabric& fabric = cloth->cooked();
    for (uint32_t v = 0; v < fabric.vertices; ++v, ++next) {
      const int64_t i = cloth->first() + static_cast<int64_t>(fabric.storage(v));
      const double3 at = fabric.position_of(v);
      rank[i] = next;
      rest[3 * i] = at.x;
      rest[3 * i + 1] = at.y;
      rest[3 * i + 2] = at.z;
    }
  }
}

template <class T>
Status ContactTables<T>::prepare(const ArenaInput& in, Simulation<T>& sim) {
  lists_before_ = lists_;
  forget_motion();
  every_ = 4;
  patience_ = backoff_ = 1;
  calm_ = wait_ = 0;
  if (!sim.contacts.state) {
    memory_.release();
    return Status::ok;
  }
  const SelfCollisionDesc& desc = *in.self_collision;
  Contacts<T>& c = sim.contacts;
  c.search = desc.search == PairSearch::complete ? Search::complete : Search::staggered;
  c.grids = static_cast<int32_t>(c.search == Search::complete ? 1 : desc.grids);
  c.window = static_cast<int32_t>(desc.window);
  c.cell = desc.cell;
  c.diagonal = desc.shifts == GridShifts::diagonal ? 1 : 0;
  c.friction = static_cast<T>(desc.friction);
  c.most_distance = 0;
  double least = INFINITY;
  for (const ClothRecord* cloth : in.cloths) {
    c.most_distance = std::max(c.most_distance, distance_of(*cloth, desc));
    least = std::min(least, distance_of(*cloth, desc));
  }
  c.by_groups = c.groups.capacity > 0 ? 1 : 0;
  c.skin = desc.skin < 0 ? usual_skin * least : desc.skin / 2;
  c.most_stop = most_stop * c.most_distance;
  c.most_drift = most_drift * c.most_distance;
  ContactState state{};
  state.limit = 16;
  state.backoff = state.crowd_backoff = 1;
  state.part = 1;
  state.ahead = 4;
  substep_ = 0;
  Status status = backend_.to_device(c.state, &state, sizeof state);
  if (status != Status::ok) return status;
  if (!memory_.data()) {
    const auto entries = static_cast<size_t>(plan::first_list_entries(in.shape));
    status = memory_.allocate(entries * entry_bytes);
    if (status != Status::ok) return status;
  }
  place_list(c);
  cloths_.resize(in.cloths.size());
  woken_.resize(in.cloths.size());
  return upload(in, sim);
}

template <class T>
Status ContactTables<T>::upload(const ArenaInput& in, Simulation<T>& sim) {
  if (!sim.contacts.state) return Status::ok;
  for (size_t k = 0; k < in.cloths.size(); ++k) {
    const ClothRecord& cloth = *in.cloths[k];
    const ContactCloth now = contact_cloth(cloth, *in.self_collision);
    const double* before = cloths_[k].origin;
    if (!std::equal(before, before + 3, now.origin)) forget_motion();
    cloths_[k] = now;
  }
  return backend_.to_device(writable(sim.contacts.cloth), cloths_.data(),
                            cloths_.size() * sizeof(ContactCloth));
}

template <class T>
Status ContactTables<T>::read_state(const Simulation<T>& sim, ContactState& state) {
  const Status status = backend_.to_host(&state, sim.contacts.state, sizeof state);
  if (status != Status::ok) return status;
  lists_ = lists_before_ + state.lists;
  listed_ = state.used;
  return status;
}

template <class T>
Status ContactTables<T>::make_room(Simulation<T>& sim, bool& wanted) {
  wanted = false;
  if (!sim.contacts.state) return Status::ok;
  ContactState state;
  const Status status = read_state(sim, state);
  if (status != Status::ok) return status;
  wanted = state.most > static_cast<unsigned long long>(sim.contacts.capacity);
  return wanted ? grow(sim, state) : status;
}

template <class T>
Status ContactTables<T>::grow(Simulation<T>& sim, const ContactState& state) {
  const auto entries = state.most + state.most / 4;
  DeviceMemory larger(context_);
  const Status status = larger.allocate(static_cast<size_t>(entries) * entry_bytes);
  if (status != Status::ok) return status;
  memory_.swap(larger);
  forget_list();
  place_list(sim.contacts);
  return status;
}

template <class T>
void ContactTables<T>::place_list(Contacts<T>& c) const {
  c.capacity = static_cast<int64_t>(memory_.bytes() / entry_bytes);
  c.impulse = reinterpret_cast<T*>(memory_.data());
  c.entry = reinterpret_cast<int32_t*>(c.impulse + c.capacity);
}

template <class T>
Status ContactTables<T>::judge(Frame<T>& frame, FrameVerdict& verdict) {
  verdict = FrameVerdict::done;
  ContactState state;
  Status status = read_state(frame.sim, state);
  if (status != Status::ok) return status;
  const bool ended = frame.begin == frame.substeps;
  if (ended && state.outrun != 0) {  // whatever else went wrong then went wrong from there
    choose_shorter(state);
    alone_ = true;
    verdict = FrameVerdict::to_make_again;
  } else if (state.most > static_cast<unsigned long long>(frame.sim.contacts.capacity)) {
    status = grow(frame.sim, state);
    verdict = ended ? FrameVerdict::to_make_again : FrameVerdict::to_go_on;
  } else {
    choose_longer(frame, state);
    alone_ = false;
  }
  return status;
}

/// Fewer substeps for a list, after a particle has outrun one.
template <class T>
void ContactTables<T>::choose_shorter(const ContactState& state) {
  const int shorter = std::min(every_ / 2, state.limit);
  every_ = std::max(1, shorter);
  calm_ = 0;
  patience_ = std::min(2 * patience_, 64);
  if (shorter > 0) return;
  wait_ = backoff_;
  backoff_ = std::min(2 * backoff_, 64);
}

/// More of them, after some frames in which none has.
template <class T>
void ContactTables<T>::choose_longer(const Frame<T>& frame, const ContactState& state) {
  if (wait_ > 0 && !alone_) --wait_;
  if (frame.list_every == 0 || ++calm_ < patience_) return;
  calm_ = 0;
  backoff_ = 1;
  every_ = std::max(every_, std::min({2 * every_, state.limit, 1024}));
}

template <class T>
Status ContactTables<T>::wake_touched(const ArenaInput& in, const Simulation<T>& sim) {
  if (!sim.contacts.state) return Status::ok;
  ContactState state;
  Status status = read_state(sim, state);
  bool any = false;
  for (const ClothRecord* cloth : in.cloths) any |= cloth->asleep;
  if (status != Status::ok || !any) return status;
  const size_t bytes = woken_.size() * sizeof woken_[0];
  status = backend_.to_host(woken_.data(), sim.contacts.woken, bytes);
  for (size_t k = 0; k < in.cloths.size() && status == Status::ok; ++k) {
    if (woken_[k] != 0) wake(*in.cloths[k]);
  }
  return status == Status::ok ? forget_touched(sim) : status;
}

template <class T>
Status ContactTables<T>::forget_touched(const Simulation<T>& sim) {
  return backend_.zero(sim.contacts.woken, woken_.size() * sizeof woken_[0]);
}

template <class T>
Status ContactTables<T>::near_pairs(const ArenaInput& in, const Simulation<T>& sim,
                                    const Vector<Vec3<T>>& positions, bool, Vector<NearPair>& out) {
  const Contacts<T>& c = sim.contacts;
  const auto blocks = static_cast<size_t>(sim.blocks);
  Vector<int64_t> start(blocks);
  Vector<int32_t> width(blocks);
  Status status = backend_.to_host(start.data(), c.row_start, blocks * sizeof(int64_t));
  if (status == Status::ok) {
    status = backend_.to_host(width.data(), c.row_width, blocks * sizeof(int32_t));
  }
  if (status != Status::ok) return status;
  Vector<int32_t> entries(
      static_cast<size_t>(std::min<int64_t>(c.capacity, static_cast<int64_t>(listed_))));
  status = backend_.to_host(entries.data(), c.entry, entries.size() * sizeof(int32_t));
  if (status != Status::ok) return status;
  // Cloth of a block, and the caller's number of a particle.
  Vector<const ClothRecord*> cloth_of(blocks);
  Vector<const ContactCloth*> contact_of(blocks);
  for (size_t k = 0; k < in.cloths.size(); ++k) {
    const auto first = static_cast<size_t>(in.cloths[k]->first()) / block_size;
    for (int b = 0; b < slices_of(*in.cloths[k]); ++b) {
      cloth_of[first + static_cast<size_t>(b)] = in.cloths[k];
      contact_of[first + static_cast<size_t>(b)] = &cloths_[k];
    }
  }
  const auto vertex = [&](const ClothRecord& cloth, int32_t i) {
    const auto own = static_cast<uint32_t>(i - cloth.first());
    return cloth.cooked().is_grid ? own : cloth.cooked().caller_of[own];
  };
  for (size_t b = 0; b < blocks; ++b) {
    for (int32_t k = 0; k < width[b]; ++k) {
      for (size_t l = 0; l < block_size; ++l) {
        const auto i = static_cast<int32_t>(b * block_size + l);
        const int32_t j = entries[static_cast<size_t>(start[b]) + size_t(k) * block_size + l];
        if (i == j) continue;
        const auto other = static_cast<size_t>(j) / block_size;
        const ClothRecord &mine = *cloth_of[b], &theirs = *cloth_of[other];
        const ContactCloth &one = *contact_of[b], &two = *contact_of[other];
        const bool same = &mine == &theirs;
        if (!meet(one, two, same)) continue;
        const NearPair pair{mine.id, theirs.id, vertex(mine, i), vertex(theirs, j)};
        const bool ordered = same ? pair.vertex_a < pair.vertex_b : mine.created < theirs.created;
        if (!ordered) continue;
        const Vec3<T>&p = positions[static_cast<size_t>(i)], &q = positions[static_cast<size_t>(j)];
        const double x = (double(p.x) + one.origin[0]) - (double(q.x) + two.origin[0]);
        const double y = (double(p.y) + one.origin[1]) - (double(q.y) + two.origin[1]);
        const double z = (double(p.z) + one.origin[2]) - (double(q.z) + two.origin[2]);
        const double reach = 0.5 * (one.distance + two.distance);
        if ((x * x + y * y) + z * z < reach * reach) out.push_back(pair);
      }
    }
  }
  const auto created_of = [&](ClothId id) {
    for (const ClothRecord* cloth : in.cloths) {
      if (cloth->id == id) return cloth->created;
    }
    return uint64_t(0);
  };
  std::sort(out.begin(), out.end(), [&](const NearPair& a, const NearPair& b) {
    if (!(a.cloth_a == b.cloth_a)) return created_of(a.cloth_a) < created_of(b.cloth_a);
    if (a.vertex_a != b.vertex_a) return a.vertex_a < b.vertex_a;
    if (!(a.cloth_b == b.cloth_b)) return created_of(a.cloth_b) < created_of(b.cloth_b);
    return a.vertex_b < b.vertex_b;
  });
  return Status::ok;
}

template class ContactTables<float>;
template class ContactTables<double>;

}  // namespace weft::api
