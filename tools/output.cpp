#include "output.h"

#include "io/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace weft::tools {

void print(const std::string& text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!whole || std::fflush(stdout) != 0) {
    throw io::OutputError(std::string("standard output: cannot be written (") +
                          std::strerror(errno) + ") free space or redirect it elsewhere");
  }
}

void print_json(const nlohmann::ordered_json& json) {
  print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void print_lines(const std::vector<std::pair<std::string, std::string>>& lines) {
  size_t width = 0;
  for (const auto& [key, value] : lines) width = std::max(width, key.size());
  std::string text;
  for (const auto& [key, value] : lines) {
    text += key + std::string(width + 2 - key.size(), ' ') + printable(value) + "\n";
  }
  print(text);
}

std::string printable(std::string text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F, two bytes in UTF-8, are control characters too.
    const bool high = byte >= 0x80 && byte < 0xA0 && i > 0 && text[i - 1] == '\xC2';
    if (high) text[i - 1] = '?';
    if (byte < ' ' || byte == 127 || high) text[i] = byte == '\n' || byte == '\r' ? ' ' : '?';
  }
  return text;
}

void print_message(const std::string& text) {
  std::fprintf(stderr, "weft: %s\n", printable(text).c_str());
}

std::string figure(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string seconds_text(double seconds) {
  if (!std::isfinite(seconds)) return "unlimited";
  if (seconds == 0 || seconds >= 1) return figure(seconds) + " s";
  if (seconds >= 1e-3) return figure(seconds * 1e3) + " ms";
  return figure(seconds * 1e6) + " us";
}

std::string bytes_text(double bytes) {
  static constexpr const char* units[] = {"B", "kB", "MB", "GB", "TB"};
  size_t unit = 0;
  for (; bytes >= 1000 && unit < 4; ++unit) bytes /= 1000;
  return figure(bytes) + " " + units[unit];
}

}  // namespace weft::tools
