// What the fuzz targets share. They are libFuzzer programs where the compiler has it, and replay
// their corpus otherwise.
#pragma once

#include "weft/core.hpp"

#include "io/error.h"
#include "io/mesh.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

/// A finding unless `held`.
inline void require(bool held) {
  if (!held) std::abort();
}
inline std::string_view text_of(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}
inline bool is_finite(const weft::double3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}
/// One line that says where, why and what to do.
inline void require_message(const weft::io::InputError& error) {
  const std::string_view text(error.what());
  require(text.size() < 2000 && text.find('\n') == text.npos);
  require(text.find(": ") != text.npos && text.find(" (") != text.npos);
}
inline void require_sound(const weft::io::Mesh& mesh) {
  require(!mesh.positions.empty() && mesh.triangles.size() % 3 == 0);
  for (const weft::double3& p : mesh.positions) require(is_finite(p));
  for (const uint32_t v : mesh.triangles) require(v < mesh.positions.size());
  require(mesh.faces.empty() || mesh.faces.size() == mesh.triangles.size() / 3);
  for (const weft::Spring& s : mesh.lines) {
    require(s.a < mesh.positions.size() && s.b < mesh.positions.size() && s.a != s.b);
  }
}
