// Standard output: JSON documents and aligned lines; messages on standard error.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

namespace weft::tools {

/// Throws OutputError when standard output takes no more.
void print(const std::string& text);
void print_json(const nlohmann::ordered_json&);
/// "key   value" lines with the values aligned; values as by printable().
void print_lines(const std::vector<std::pair<std::string, std::string>>&);

/// On one line and without control characters, which a terminal would obey.
std::string printable(std::string text);

/// "weft: TEXT" on one line of standard error.
void print_message(const std::string& text);

std::string seconds_text(double seconds);  ///< "3.7 ms"
std::string bytes_text(double bytes);      ///< "12.3 MB"
std::string figure(double value, int digits = 4);

}  // namespace weft::tools
