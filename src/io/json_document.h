// JSON text to values, stricter than the parser it uses.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace weft::io {

using Json = nlohmann::json;

/// InputError, with `name`, the JSON path and the line, on bad syntax, a key given twice, a number
/// that overflows, or nesting deeper than 32.
Json parse_json(std::string_view text, const std::string& name);

/// `.key`, with unprintable characters of the key replaced.
std::string path_of_key(std::string_view key);

}  // namespace weft::io
