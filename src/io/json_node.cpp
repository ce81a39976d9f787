#include "io/json_node.h"

#include "io/error.h"
#include "io/nearest.h"
#include "io/text_cursor.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

namespace weft::io {

bool Node::is_number() const { return value_->is_number(); }
bool Node::is_object() const { return value_->is_object(); }
bool Node::is_string() const { return value_->is_string(); }
bool Node::is_null() const { return value_->is_null(); }

std::string Node::path() const {
  std::vector<const Node*> line;
  for (const Node* node = this; node->parent_; node = node->parent_) line.push_back(node);
  std::string path = "$";
  for (auto node = line.rbegin(); node != line.rend(); ++node) {
    if ((*node)->key_)
      path += path_of_key((*node)->key_);
    else
      path += "[" + std::to_string((*node)->index_) + "]";
  }
  return path;
}

std::string Node::value_text() const {
  if (value_->is_array()) return "an array of " + std::to_string(value_->size());
  if (value_->is_object()) return "an object";
  if (value_->is_number_float()) return number_text(value_->get<double>());
  const std::string text = value_->dump();
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

void Node::fail(const std::string& problem) const { throw InputError(path() + ": " + problem); }

void Node::out_of_range(const std::string& why, const std::string& remedy) const {
  fail(value_text() + " is out of range (" + why + ") " + remedy);
}

void Node::wrong_type(const char* needed) const {
  fail(value_text() + " has the wrong type (" + value_->type_name() + ") give " + needed);
}

void Node::require_object(std::initializer_list<const char*> keys) const {
  if (!value_->is_object()) wrong_type("an object");
  for (const auto& [key, value] : value_->items()) {
    bool known = false;
    std::string allowed;
    for (const char* candidate : keys) {
      known = known || key == candidate;
      allowed += (allowed.empty() ? "" : ", ") + std::string(candidate);
    }
    if (known) continue;
    const std::string nearest = nearest_word(key, keys);
    throw InputError(path() + path_of_key(key) + ": unknown key with the value " +
                     Node(value, *this, "", 0).value_text() + " (known are " + allowed + ") " +
                     (nearest.empty() ? "remove it" : "did you mean \"" + nearest + "\"?"));
  }
}

std::optional<Node> Node::find(const char* key) const& {
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return Node(*found, *this, key, 0);
}

Node Node::at(const char* key, const char* remedy) const& {
  if (const auto node = find(key)) return *node;
  throw InputError(path() + path_of_key(key) + ": is missing (the key is required) give " + remedy);
}

const char* Node::exactly_one(std::initializer_list<const char*> keys) const {
  const char* found = nullptr;
  std::string all, present;
  for (const char* key : keys) {
    all += (all.empty() ? "" : ", ") + std::string(key);
    if (!value_->contains(key)) continue;
    found = key;
    present += (present.empty() ? "" : " and ") + std::string(key);
  }
  if (!found) fail("has none of " + all + " (exactly one is required) give one of them");
  if (present != found) fail("has " + present + " (exactly one is allowed) keep one of " + all);
  return found;
}

size_t Node::array_size(const char* what) const {
  if (!value_->is_array()) wrong_type(what);
  return value_->size();
}

Node Node::operator[](size_t index) const& { return Node((*value_)[index], *this, nullptr, index); }

double Node::number(Sign sign) const {
  if (!value_->is_number()) wrong_type("a number");
  constexpr double largest = 1e18;  // of all that the library takes
  const double value = value_->get<double>();
  if (std::abs(value) > largest) out_of_range("numbers reach to 1e18", "give a smaller one");
  if (sign == Sign::not_negative && value < 0) out_of_range("it is negative", "give a number >= 0");
  if (sign == Sign::positive && !(value > 0))
    out_of_range("it is not positive", "give a number > 0");
  return value;
}

// 640.0 and 1e3 are integers, too; a number that no int64 holds is none that is asked for.
std::optional<int64_t> Node::whole() const {
  if (value_->is_number_float()) {
    const double value = value_->get<double>();
    if (value != std::floor(value)) wrong_type("an integer");
    constexpr double most = 9007199254740992.0;  // beyond it a double is not one integer
    if (std::abs(value) > most) return std::nullopt;
    return int64_t(value);
  }
  if (!value_->is_number_integer()) wrong_type("an integer");
  if (value_->is_number_unsigned() && value_->get<uint64_t>() > uint64_t(INT64_MAX)) {
    return std::nullopt;
  }
  return value_->get<int64_t>();
}

int64_t Node::integer(int64_t least, int64_t most, const char* why) const {
  const std::string upper = most == INT64_MAX ? "" : " and <= " + std::to_string(most);
  const std::optional<int64_t> value = whole();
  if (!value || *value < least || *value > most) {
    out_of_range(why, "give an integer >= " + std::to_string(least) + upper);
  }
  return *value;
}

bool Node::boolean() const {
  if (!value_->is_boolean()) wrong_type("true or false");
  return value_->get<bool>();
}

const std::string& Node::text() const {
  if (!value_->is_string()) wrong_type("a string");
  return value_->get_ref<const std::string&>();
}

double3 Node::vector() const {
  if (array_size("an array of three numbers") != 3) {
    fail(value_text() + " is not a vector (it has x, y and z) give an array of three numbers");
  }
  return {(*this)[0].number(), (*this)[1].number(), (*this)[2].number()};
}

uint32_t Node::index(uint64_t count, const char* what) const {
  const std::optional<int64_t> value = whole();
  if (!value || *value < 0 || uint64_t(*value) >= count) {
    out_of_range("there are " + std::to_string(count) + " " + what,
                 "give an integer >= 0 and < " + std::to_string(count));
  }
  return uint32_t(*value);
}

}  // namespace weft::io
