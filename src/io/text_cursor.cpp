#include "io/text_cursor.h"

#include <algorithm>
#include <cstring>

namespace weft::io {
namespace {

// from_chars reports a number below the smallest double like one above the largest; the first is 0.
NumberFault out_of_range(const char* begin, const char* end, double& value) {
  value = std::strtod(std::string(begin, end).c_str(), nullptr);
  return std::isfinite(value) ? NumberFault::none : NumberFault::not_finite;
}

const char* skip_plus(const Cursor& cursor) {
  const bool plus = cursor.end - cursor.at > 1 && cursor.at[0] == '+' && cursor.at[1] != '-';
  return cursor.at + (plus ? 1 : 0);
}

}  // namespace

std::string_view next_line(Cursor& cursor) {
  const char* begin = cursor.at;
  const auto left = size_t(cursor.end - begin);
  const void* newline = left ? std::memchr(begin, '\n', left) : nullptr;
  const char* end = newline ? static_cast<const char*>(newline) : cursor.end;
  cursor.at = newline ? end + 1 : end;
  return {begin, size_t(end - begin)};
}

const char* to_text(NumberFault fault) {
  switch (fault) {
    case NumberFault::none:
      return "";
    case NumberFault::missing:
      return "is missing (the line is too short) add the number";
    case NumberFault::unparsable:
      return "is not a number (or has something behind it) correct it";
    case NumberFault::not_finite:
      return "is not finite (positions are) give a finite number";
  }
  return "";
}

NumberFault next_real(Cursor& cursor, double& value) {
  if (at_end(cursor)) return NumberFault::missing;
  const char* begin = skip_plus(cursor);
  const auto [stop, code] = std::from_chars(begin, cursor.end, value);
  if (code == std::errc::invalid_argument) return NumberFault::unparsable;
  if (stop != cursor.end && !is_blank(*stop)) return NumberFault::unparsable;
  if (code == std::errc::result_out_of_range) {
    const NumberFault fault = out_of_range(begin, stop, value);
    if (fault != NumberFault::none) return fault;
  }
  if (!std::isfinite(value)) return NumberFault::not_finite;
  cursor.at = stop;
  return NumberFault::none;
}

NumberFault next_integer(Cursor& cursor, int64_t& value) {
  if (at_end(cursor)) return NumberFault::missing;
  const auto [stop, code] = std::from_chars(skip_plus(cursor), cursor.end, value);
  if (code != std::errc{}) return NumberFault::unparsable;
  if (stop != cursor.end && !is_blank(*stop)) return NumberFault::unparsable;
  cursor.at = stop;
  return NumberFault::none;
}

std::string shown(std::string_view text) {
  constexpr size_t longest = 40;
  std::string out;
  for (const char c : text.substr(0, longest)) out += c >= ' ' && c < 127 ? c : '?';
  if (text.size() > longest) out += "...";
  return out;
}

std::string quoted(std::string_view text) { return "'" + shown(text) + "'"; }

std::string number_text(double value) {
  char buffer[32];
  const auto [end, code] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return code == std::errc{} ? std::string(buffer, end) : "?";
}

size_t line_number(std::string_view text, size_t offset) {
  const auto upto = text.substr(0, offset);
  return size_t(std::count(upto.begin(), upto.end(), '\n')) + 1;
}

}  // namespace weft::io
