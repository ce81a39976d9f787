// "Did you mean": the known word that a misspelt one is closest to.
#pragma once

#include <string>
#include <vector>

namespace weft::io {

/// Empty when no word is within a third of the length in single-letter edits.
std::string nearest_word(const std::string& word, const std::vector<const char*>& known);

}  // namespace weft::io
