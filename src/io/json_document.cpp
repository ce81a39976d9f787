#include "io/json_document.h"

#include "io/error.h"
#include "io/text_cursor.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace weft::io {
namespace {

constexpr size_t deepest = 32;
constexpr size_t longest_message = 300;

class Builder final : public nlohmann::json_sax<Json> {
 public:
  Builder(std::string_view text, const std::string& name) : text_(text), name_(name) {}
  Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    Level& level = levels_.back();
    level.key = key;
    if (level.node->contains(key)) {
      fail(path() + ": the key is given twice (only one can hold) remove one of the two");
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& reason) override {
    const std::string line = ", line " + std::to_string(line_number(text_, position));
    if (reason.id == 406) {
      fail(path() + line + ": " + token +
           " overflows (a number ends at 1.8e308) give a smaller one");
    }
    std::string what = reason.what();
    what = what.substr(what.find(']') + 1, longest_message);
    fail(path() + line + ":" + what + " (this is not JSON) correct it");
  }

 private:
  struct Level {
    Json* node;
    std::string key;
  };

  [[noreturn]] void fail(const std::string& text) const { throw InputError(name_ + ": " + text); }

  // Of the value at hand.
  std::string path() const {
    std::string path = "$";
    for (const Level& level : levels_) {
      // An array that is open above already holds the element; the innermost waits for it.
      const size_t inner = &level == &levels_.back() ? 0 : 1;
      if (level.node->is_array())
        path += "[" + std::to_string(level.node->size() - inner) + "]";
      else if (!level.key.empty())
        path += path_of_key(level.key);
    }
    return path;
  }

  template <class Value>
  Json* place(Value&& value) {
    if (levels_.empty()) return &(root_ = Json(std::forward<Value>(value)));
    Level& level = levels_.back();
    if (level.node->is_object()) {
      return &((*level.node)[level.key] = Json(std::forward<Value>(value)));
    }
    level.node->push_back(Json(std::forward<Value>(value)));
    return &level.node->back();
  }
  template <class Value>
  bool add(Value&& value) {
    place(std::forward<Value>(value));
    return true;
  }
  bool open(Json container) {
    if (levels_.size() == deepest) {
      fail(path() + ": is nested deeper than " + std::to_string(deepest) +
           " levels (no scene is) flatten it");
    }
    Json* node = place(std::move(container));
    levels_.push_back({node, {}});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& name_;
  Json root_;
  std::vector<Level> levels_;
};

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  if (text.empty()) throw InputError(name + ": is empty (a JSON document is needed) fill it");
  // The parser takes a zero byte for the end.
  if (const size_t zero = text.find('\0'); zero != std::string_view::npos) {
    throw InputError(name + ": line " + std::to_string(line_number(text, zero)) +
                     ": has a zero byte (this is not text) give a JSON document");
  }
  Builder builder(text, name);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

std::string path_of_key(std::string_view key) { return "." + shown(key); }

}  // namespace weft::io
