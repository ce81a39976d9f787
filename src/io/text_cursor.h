// Walking through text by words and numbers, without copies and without a locale.
#pragma once

#include <cmath>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace weft::io {

/// What is left of a piece of text.
struct Cursor {
  const char* at;
  const char* end;
  explicit Cursor(std::string_view text) : at(text.data()), end(text.data() + text.size()) {}
};

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

inline void skip_blanks(Cursor& cursor) {
  while (cursor.at < cursor.end && is_blank(*cursor.at)) ++cursor.at;
}

/// True when nothing but blanks is left.
inline bool at_end(Cursor& cursor) {
  skip_blanks(cursor);
  return cursor.at == cursor.end;
}

/// The next run of non-blank characters; empty at the end.
inline std::string_view next_word(Cursor& cursor) {
  skip_blanks(cursor);
  const char* begin = cursor.at;
  while (cursor.at < cursor.end && !is_blank(*cursor.at)) ++cursor.at;
  return {begin, size_t(cursor.at - begin)};
}

/// The next line, without its end, and the cursor behind it.
std::string_view next_line(Cursor& cursor);

enum class NumberFault : uint8_t { none, missing, unparsable, not_finite };
/// "is not a number (...)" and so on; the remedy included.
const char* to_text(NumberFault);

/// A finite number that ends at a blank or at the end. On a fault the cursor is in front of the
/// word.
NumberFault next_real(Cursor& cursor, double& value);
/// A whole number likewise.
NumberFault next_integer(Cursor& cursor, int64_t& value);

/// At most 40 characters of a text from a file; a '?' for each that cannot be printed.
std::string shown(std::string_view);
/// `text` fit for a one-line message: at most 40 characters, unprintable ones as '?'.
std::string quoted(std::string_view text);
/// The shortest text that reads back as the same number.
std::string number_text(double value);
/// Line number, from 1, of an offset in `text`.
size_t line_number(std::string_view text, size_t offset);

}  // namespace weft::io
