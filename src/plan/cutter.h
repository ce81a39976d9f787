// The one walk over the lists of arrays (`arrays` of the state structs): without memory it gives
// the bytes, at the device's memory the views that kernels see, at an image of it the places to
// fill.
#pragma once

#include <cstdint>

#include "plan/members.h"
#include "state/simulation.h"

namespace weft::plan {

/// Hands out arrays one after the other, each aligned to 128 bytes.
class Cutter {
 public:
  /// `base`: null to count bytes only, else aligned to 128. `vector_stride`: how the back end
  /// stores vectors (base/portability.h).
  Cutter(char* base, size_t vector_stride) : base_(base), stride_(vector_stride) {}

  template <class Element>
  void operator()(Element*& view, int64_t count) {
    view = reinterpret_cast<Element*>(take(static_cast<size_t>(count) * sizeof(Element)));
  }
  /// An array of vectors with `guard` elements before and behind, which are not counted.
  template <class T>
  void operator()(Vec3Array<T>& view, int64_t count, int64_t guard = 0) {
    view = {nullptr, 0};
    if (count == 0) return;
    const size_t band = (static_cast<size_t>(guard) + 31) / 32 * 32;
    const size_t whole = static_cast<size_t>(count) + 2 * band;
    if (stride_ > 1) {
      view = {behind<T>(take(whole * stride_ * sizeof(T)), band * stride_), 1};
      return;
    }
    // An odd number of lines from component to component: powers of two would share cache sets.
    const size_t pitch = (whole + 31) / 32 * 32 + (whole / 32 % 2 == 0 ? 32 : 64);
    view = {behind<T>(take(3 * pitch * sizeof(T)), band), pitch};
  }
  template <class Group, class Counts>
  void group(Group& views, const Counts& counts) {
    static_assert(members_of<Group>() == listed_members_of<Group, Counts>(),
                  "a member is missing in the struct's list of arrays");
    views.arrays(*this, counts);
  }
  template <class Number, class Value>
  void number(Number& to, Value value) {
    to = static_cast<Number>(value);
  }
  /// What others set.
  template <class... Number>
  void later(const Number&...) {}

  size_t bytes() const { return bytes_; }

 private:
  char* take(size_t bytes) {
    if (bytes == 0) return nullptr;
    char* at = base_ ? base_ + bytes_ : nullptr;
    bytes_ += (bytes + 127) / 128 * 128;
    return at;
  }
  template <class T>
  static T* behind(char* at, size_t scalars) {
    return at ? reinterpret_cast<T*>(at) + scalars : nullptr;
  }

  char* base_;
  size_t stride_, bytes_ = 0;
};

/// Adds up what arrays hold, without what lies between them.
class ArrayBytes {
 public:
  template <class Element>
  void operator()(Element*&, int64_t count) {
    bytes_ += static_cast<size_t>(count) * sizeof(Element);
  }
  template <class T>
  void operator()(Vec3Array<T>&, int64_t count, int64_t = 0) {
    bytes_ += static_cast<size_t>(count) * 3 * sizeof(T);
  }
  template <class... Number>
  void later(const Number&...) {}
  size_t bytes() const { return bytes_; }

 private:
  size_t bytes_ = 0;
};

}  // namespace weft::plan
