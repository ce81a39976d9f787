// Numbers to and from the byte order of files, whatever the machine's is.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>

namespace weft::io {

/// Writes `value` at `at`; returns the place behind it.
template <class Value>
char* put_little(char* at, Value value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof value);
  return std::copy(bytes, bytes + sizeof value, at);
}

/// Reads sizeof(Value) bytes at `at`.
template <class Value>
Value get_little(const char* at) {
  char bytes[sizeof(Value)];
  std::memcpy(bytes, at, sizeof bytes);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof bytes);
  Value value;
  std::memcpy(&value, bytes, sizeof bytes);
  return value;
}

}  // namespace weft::io
