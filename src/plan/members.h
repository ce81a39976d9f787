// Whether a struct of views lists all of its members: counts them, and counts the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace weft::plan {

/// Turns into whatever a member is initialised with.
struct AnyValue {
  template <class T>
  constexpr operator T() const;
};

template <class Struct, size_t... Index>
constexpr bool takes(std::index_sequence<Index...>) {
  return requires { Struct{(static_cast<void>(Index), AnyValue{})...}; };
}

/// Members of an aggregate; an array of n counts as n.
template <class Struct, size_t n = 1>
constexpr size_t members_of() {
  if constexpr (takes<Struct>(std::make_index_sequence<n>())) {
    return members_of<Struct, n + 1>();
  } else {
    return n - 1;
  }
}

/// Walks a list and only counts; a group is one member of its owner.
class MemberCounter {
 public:
  template <class View>
  constexpr void operator()(const View&, int64_t, int64_t = 0) {
    ++count_;
  }
  template <class Group, class Counts>
  constexpr void group(const Group&, const Counts&) {
    ++count_;
  }
  template <class Number, class Value>
  constexpr void number(const Number&, const Value&) {
    ++count_;
  }
  template <class... Number>
  constexpr void later(const Number&... number) {
    ((count_ += elements(number)), ...);
  }
  constexpr size_t count() const { return count_; }

 private:
  template <class Element, size_t n>
  static constexpr size_t elements(const Element (&)[n]) {
    return n;
  }
  template <class Element>
  static constexpr size_t elements(const Element&) {
    return 1;
  }
  size_t count_ = 0;
};

template <class Struct, class Counts>
constexpr size_t listed_members_of() {
  Struct views{};
  MemberCounter counter;
  views.arrays(counter, Counts{});
  return counter.count();
}

}  // namespace weft::plan
