// The header of a PLY file: which elements follow, with which properties, in which encoding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace weft::io {

enum class PlyFormat : uint8_t { ascii, little_endian, big_endian };
enum class PlyType : uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr size_t size_of(PlyType type) {
  constexpr size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[size_t(type)];
}
constexpr bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The fewest bytes that one of these takes in the body.
  uint64_t least_bytes(PlyFormat) const;
  /// Index of a property, or properties.size().
  size_t find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> warnings;
  size_t body = 0;  ///< offset of the first byte after the header

  const PlyElement* find(std::string_view element) const;
};

/// InputError names `name`, the line and the value.
PlyHeader read_ply_header(std::string_view text, const std::string& name);

}  // namespace weft::io
