#include "scene/faces.h"

#include <algorithm>

namespace weft::scene {

namespace {

/// A triangle with its vertices in ascending order.
struct Key {
  uint32_t v[3];
  uint32_t face;
  bool odd;  ///< an odd number of swaps from the order as given

  bool is_same(const Key& other) const {
    return v[0] == other.v[0] && v[1] == other.v[1] && v[2] == other.v[2];
  }
  friend bool operator<(const Key& x, const Key& y) {
    return x.v[0] != y.v[0]   ? x.v[0] < y.v[0]
           : x.v[1] != y.v[1] ? x.v[1] < y.v[1]
           : x.v[2] != y.v[2] ? x.v[2] < y.v[2]
                              : x.face < y.face;
  }
};

Key key_of(const uint32_t* corner, uint32_t face) {
  Key key{{corner[0], corner[1], corner[2]}, face, false};
  const auto order = [&key](int i, int j) {
    if (key.v[i] <= key.v[j]) return;
    std::swap(key.v[i], key.v[j]);
    key.odd = !key.odd;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return key;
}

bool has_three(const Key& k) { return k.v[0] != k.v[1] && k.v[1] != k.v[2]; }

/// An edge of a kept triangle.
struct KeptSide {
  uint32_t low, high, face;  ///< number among the kept
  bool ascending;            ///< as the triangle was given first
  friend bool operator<(const KeptSide& x, const KeptSide& y) {
    return x.low != y.low ? x.low < y.low : x.high != y.high ? x.high < y.high : x.face < y.face;
  }
};

/// Turns what may be turned as its neighbours run.
class Turner {
 public:
  Turner(const Vector<uint32_t>& corners, Faces& faces) : faces_(faces) {
    for (uint32_t k = 0; k < faces.kept.size(); ++k) {
      const uint32_t* v = &corners[3 * size_t(faces.kept[k])];
      for (int c = 0; c < 3; ++c) {
        const uint32_t a = v[c], b = v[(c + 1) % 3];
        if (a != b) sides_.push_back({std::min(a, b), std::max(a, b), k, a < b});
      }
    }
    std::sort(sides_.begin(), sides_.end());
    link();
  }

  void turn() {
    const size_t count = faces_.kept.size();
    faces_.turned.assign(count, false);
    known_.assign(count, false);
    for (uint32_t k = 0; k < count; ++k) {
      if (!faces_.both_ways[k]) reach(k);
    }
    spread();
    for (uint32_t k = 0; k < count; ++k) {
      if (known_[k]) continue;
      reach(k);
      spread();
    }
  }

 private:
  struct Link {
    uint32_t face;
    bool same;  ///< both run the same way along the edge
  };

  void link() {
    links_.assign(3 * faces_.kept.size(), {~0u, false});
    Vector<uint8_t> used(faces_.kept.size(), 0);
    for (size_t first = 0; first < sides_.size();) {
      size_t end = first + 1;
      while (end < sides_.size() && sides_[end].low == sides_[first].low &&
             sides_[end].high == sides_[first].high) {
        ++end;
      }
      if (end - first == 2 && sides_[first].face != sides_[first + 1].face) {
        const KeptSide &x = sides_[first], &y = sides_[first + 1];
        const bool same = x.ascending == y.ascending;
        links_[3 * size_t(x.face) + used[x.face]++] = {y.face, same};
        links_[3 * size_t(y.face) + used[y.face]++] = {x.face, same};
      }
      first = end;
    }
  }

  void reach(uint32_t face) {
    known_[face] = true;
    reached_.push_back(face);
  }

  void spread() {
    for (; next_ < reached_.size(); ++next_) {
      const uint32_t k = reached_[next_];
      for (size_t c = 0; c < 3; ++c) {
        const Link& to = links_[3 * size_t(k) + c];
        if (to.face == ~0u || known_[to.face]) continue;
        faces_.turned[to.face] = faces_.turned[k] != to.same;
        reach(to.face);
      }
    }
  }

  Faces& faces_;
  Vector<KeptSide> sides_;
  Vector<Link> links_;
  Vector<bool> known_;
  Vector<uint32_t> reached_;
  size_t next_ = 0;
};

}  // namespace

Faces distinct_faces(const Vector<uint32_t>& corners) {
  const auto count = static_cast<uint32_t>(corners.size() / 3);
  Vector<Key> keys;
  keys.reserve(count);
  for (uint32_t t = 0; t < count; ++t) {
    const Key key = key_of(&corners[3 * size_t(t)], t);
    if (has_three(key)) keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  Faces faces;
  Vector<bool> again(count, false), both(count, false);
  bool turnable = false;
  for (size_t first = 0; first < keys.size();) {
    size_t end = first + 1;
    for (; end < keys.size() && keys[end].is_same(keys[first]); ++end) {
      const uint32_t t = keys[end].face;
      if (faces.repeats++ == 0 || t < faces.first_repeat) {
        faces.first_repeat = t;
        faces.its_like = keys[first].face;
      }
      again[t] = true;
      if (keys[end].odd != keys[first].odd) both[keys[first].face] = turnable = true;
    }
    first = end;
  }
  faces.kept.reserve(count);
  for (uint32_t t = 0; t < count; ++t) {
    if (!again[t]) faces.kept.push_back(t);
  }
  if (!turnable) return faces;
  for (const uint32_t t : faces.kept) faces.both_ways.push_back(both[t]);
  Turner(corners, faces).turn();
  return faces;
}

}  // namespace weft::scene
