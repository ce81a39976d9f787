// A JSON value that knows its path, with getters that fail with a message a user can act on.
#pragma once

#include "weft/core.hpp"

#include "io/json_document.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace weft::io {

/// What a number may be besides finite.
enum class Sign : uint8_t { any, not_negative, positive };

/// Points to its parent for the path, so a parent outlives its children: children can only be made
/// from a named node. All failures are InputErrors `PATH: VALUE is ... (why) what to do`.
class Node {
 public:
  explicit Node(const Json& root) : value_(&root) {}

  std::string path() const;
  /// The value in at most 60 characters.
  std::string value_text() const;
  bool is_number() const;
  bool is_object() const;
  bool is_string() const;
  bool is_null() const;

  /// `PATH: problem`
  [[noreturn]] void fail(const std::string& problem) const;
  /// `PATH: VALUE is out of range (why) remedy`
  [[noreturn]] void out_of_range(const std::string& why, const std::string& remedy) const;

  /// An object with no other keys than these.
  void require_object(std::initializer_list<const char*> keys) const;
  std::optional<Node> find(const char* key) const&;
  std::optional<Node> find(const char* key) const&& = delete;
  /// The key must be there; `remedy` says what to give.
  Node at(const char* key, const char* remedy) const&;
  Node at(const char* key, const char* remedy) const&& = delete;
  /// The one key of these that is there; none or several is an error.
  const char* exactly_one(std::initializer_list<const char*> keys) const;

  /// Length of an array; anything else is an error that asks for `what`.
  size_t array_size(const char* what) const;
  Node operator[](size_t index) const&;
  Node operator[](size_t index) const&& = delete;

  double number(Sign = Sign::any) const;
  int64_t integer(int64_t least, int64_t most, const char* why) const;
  bool boolean() const;
  const std::string& text() const;
  double3 vector() const;
  /// A vertex index below `count`.
  uint32_t index(uint64_t count, const char* what) const;

  template <class Value>
  Value choice(std::initializer_list<std::pair<const char*, Value>> choices) const {
    std::string allowed;
    for (const auto& [name, value] : choices) {
      if (is_string() && text() == name) return value;
      allowed += (allowed.empty() ? "\"" : " or \"") + std::string(name) + "\"";
    }
    fail(value_text() + " is not one of the choices (they are fixed) give " + allowed);
  }

 private:
  Node(const Json& value, const Node& parent, const char* key, size_t index)
      : value_(&value), parent_(&parent), key_(key), index_(index) {}
  [[noreturn]] void wrong_type(const char* needed) const;
  /// Nothing when it is an integer that no int64 holds.
  std::optional<int64_t> whole() const;

  const Json* value_;
  const Node* parent_ = nullptr;
  const char* key_ = nullptr;  ///< null: element `index_` of an array
  size_t index_ = 0;
};

}  // namespace weft::io
