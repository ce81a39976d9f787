// Texts for people: `<problem> (<why it is a problem>) <what to do>`. Host code only. They take no
// memory, so that there is a text where there is none.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <exception>
#include <string>

#include "base/memory_host.h"

namespace weft {

/// A text of at most 511 characters; what is longer is cut.
class Text {
 public:
  Text() noexcept { at_[0] = '\0'; }
  Text(const char* words) noexcept { std::snprintf(at_, sizeof at_, "%s", words); }

  const char* c_str() const noexcept { return at_; }
  bool empty() const noexcept { return at_[0] == '\0'; }
  /// For those who may ask for memory.
  operator String() const { return at_; }
  operator std::string() const { return at_; }

  [[gnu::format(printf, 1, 0)]] static Text format(const char* format, va_list args) noexcept {
    Text out;
    std::vsnprintf(out.at_, sizeof out.at_, format, args);
    return out;
  }

 private:
  char at_[512];
};

/// printf into a text.
[[gnu::format(printf, 1, 2)]] inline Text text(const char* format, ...) noexcept {
  va_list args;
  va_start(args, format);
  const Text out = Text::format(format, args);
  va_end(args);
  return out;
}

/// Thrown inside the library for input that cannot be used; becomes Status::invalid_argument and a
/// log message at the public interface.
class InvalidInput : public std::exception {
 public:
  explicit InvalidInput(const Text& words) noexcept : words_(words) {}
  const char* what() const noexcept override { return words_.c_str(); }

 private:
  Text words_;
};

}  // namespace weft
