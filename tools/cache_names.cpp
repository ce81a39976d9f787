#include "cache_names.h"

#include <algorithm>
#include <map>
#include <set>

namespace weft::tools {
namespace {

std::string possible(const std::string& cloth) {
  std::string name = cloth.substr(0, 200);  // a folder's entry has at most 255 bytes
  for (char& c : name) {
    const bool odd = static_cast<unsigned char>(c) < ' ' || c == '/' || c == '\\' || c == ':';
    if (odd) c = '_';
  }
  if (name[0] == '.') name[0] = '_';
  return name;
}

// Some file systems do not tell "Flag" from "flag".
std::string folded(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return name;
}

}  // namespace

bool is_frame_stem(const std::string& name) {
  constexpr size_t digits = 6;
  return name.starts_with("frame_") && name.size() >= sizeof "frame_" - 1 + digits &&
         name.find_first_not_of("0123456789", sizeof "frame_" - 1) == std::string::npos;
}

std::vector<std::string> cache_names(const std::vector<std::string>& cloths) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  std::map<std::string, int> last;  // number behind a name
  for (const std::string& cloth : cloths) {
    const std::string name = possible(cloth);
    int& number = last[folded(name)];
    std::string free = name;
    while (is_frame_stem(folded(free)) || !taken.insert(folded(free)).second) {
      number = std::max(number + 1, 2);
      free = name + "_" + std::to_string(number);
    }
    names.push_back(free);
  }
  return names;
}

}  // namespace weft::tools
