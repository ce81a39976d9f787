// The pairs of a list that are near, as the caller numbers them.
#include <algorithm>

#include "api/arena/contacts.h"
#include "api/arena/device_vectors.h"
#include "api/arena/image.h"

namespace weft::api {

namespace {

/// Whether two particles of these cloths may meet at all.
bool meet(const ContactCloth& a, const ContactCloth& b, bool same) {
  return same ? a.itself != 0 : a.others && b.others && (a.layers & b.layers) != 0;
}

}  // namespace

template <class T>
Status ContactTables<T>::near_pairs(const ArenaInput& in, Simulation<T>& sim, Frame<T> frame,
                                    bool with_excluded, Vector<NearPair>& out) {
  Status status = upload(in, sim);
  for (bool wanted = true; wanted && status == Status::ok;) {
    frame.sim = sim;
    frame.sim.contacts.with_excluded = with_excluded ? 1 : 0;
    forget_list();
    status = backend_.pairs(frame);
    if (status == Status::ok) status = make_room(sim, wanted);
  }
  const auto blocks = static_cast<size_t>(sim.blocks);
  Vector<Vec3<T>> positions;
  if (status == Status::ok) {
    status = fetch_vectors(backend_, sim.x[0], 0, blocks * block_size, positions);
  }
  if (status != Status::ok) return status;
  const Contacts<T>& c = sim.contacts;
  Vector<int64_t> start(blocks);
  Vector<int32_t> width(blocks);
  status = backend_.to_host(start.data(), c.row_start, blocks * sizeof(int64_t));
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

template Status ContactTables<float>::near_pairs(const ArenaInput&, Simulation<float>&,
                                                 Frame<float>, bool, Vector<NearPair>&);
template Status ContactTables<double>::near_pairs(const ArenaInput&, Simulation<double>&,
                                                  Frame<double>, bool, Vector<NearPair>&);

}  // namespace weft::api
