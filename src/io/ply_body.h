// The two encodings of a PLY body behind one set of calls:
//
//   begin_record(), then per property next_real() or next_integer() or skip(), then end_record().
//
// Each call returns false when the body has no such value; `fault()` then says why.
#pragma once

#include "io/ply_header.h"
#include "io/text_cursor.h"

#include <bit>
#include <cstring>

namespace weft::io {

/// Records are lines, values are words.
class PlyTextBody {
 public:
  explicit PlyTextBody(std::string_view body) : body_(body), line_(std::string_view()) {}

  bool begin_record() {
    do {
      if (body_.at == body_.end) return end_of_file();
      line_ = Cursor(next_line(body_));
    } while (at_end(line_));
    return true;
  }
  bool next_real(PlyType, double& value) { return keep(io::next_real(line_, value)); }
  bool next_integer(PlyType, int64_t& value) { return keep(io::next_integer(line_, value)); }
  bool skip(PlyType, uint64_t count) {
    for (; count > 0; --count) {
      if (next_word(line_).empty()) return keep(NumberFault::missing);
    }
    return true;
  }
  bool end_record() {
    if (at_end(line_)) return true;
    fault_ =
        quoted(next_word(line_)) + " is one value too many (the header declares fewer) remove it";
    return false;
  }

  uint64_t bytes_left() const { return uint64_t(body_.end - body_.at) + 1; }
  /// What follows the records, empty lines left out.
  uint64_t spare_bytes() {
    while (body_.at < body_.end && (is_blank(*body_.at) || *body_.at == '\n')) ++body_.at;
    return uint64_t(body_.end - body_.at);
  }
  /// An upper bound for the values that the record at hand still holds.
  uint64_t values_left(PlyType) const { return uint64_t(line_.end - line_.at); }
  const std::string& fault() const { return fault_; }
  const char* position() const { return line_.at; }

 private:
  bool end_of_file() {
    fault_ = "the file ends here (the header declares more) give the whole file";
    return false;
  }
  bool keep(NumberFault fault) {
    if (fault == NumberFault::none) return true;
    fault_ = quoted(next_word(line_)) + " " + to_text(fault);
    return false;
  }

  Cursor body_;
  Cursor line_;
  std::string fault_;
};

/// Values follow each other without padding.
class PlyBinaryBody {
 public:
  PlyBinaryBody(std::string_view body, bool big_endian)
      : body_(body), swap_(big_endian != (std::endian::native == std::endian::big)) {}

  bool begin_record() { return true; }
  bool next_real(PlyType type, double& value) {
    if (type == PlyType::float64) return load<double>(value);
    if (type == PlyType::float32) return load<float>(value);
    int64_t whole = 0;
    if (!next_integer(type, whole)) return false;
    value = double(whole);
    return true;
  }
  bool next_integer(PlyType type, int64_t& value) {
    switch (type) {
      case PlyType::int8:
        return load<int8_t>(value);
      case PlyType::uint8:
        return load<uint8_t>(value);
      case PlyType::int16:
        return load<int16_t>(value);
      case PlyType::uint16:
        return load<uint16_t>(value);
      case PlyType::int32:
        return load<int32_t>(value);
      case PlyType::uint32:
        return load<uint32_t>(value);
      default:
        break;
    }
    fault_ = "is not an integer property (indices are) declare it as one";
    return false;
  }
  bool skip(PlyType type, uint64_t count) {
    if (count > bytes_left() / size_of(type)) return end_of_file();
    body_.at += count * size_of(type);
    return true;
  }
  bool end_record() { return true; }

  uint64_t bytes_left() const { return uint64_t(body_.end - body_.at); }
  uint64_t spare_bytes() const { return bytes_left(); }
  uint64_t values_left(PlyType type) const { return bytes_left() / size_of(type); }
  const std::string& fault() const { return fault_; }
  const char* position() const { return body_.at; }

 private:
  template <class Stored, class Value>
  bool load(Value& value) {
    if (bytes_left() < sizeof(Stored)) return end_of_file();
    char bytes[sizeof(Stored)];
    std::memcpy(bytes, body_.at, sizeof bytes);
    if (swap_) {
      for (size_t i = 0; i < sizeof bytes / 2; ++i)
        std::swap(bytes[i], bytes[sizeof bytes - 1 - i]);
    }
    Stored stored;
    std::memcpy(&stored, bytes, sizeof bytes);
    value = static_cast<Value>(stored);
    body_.at += sizeof bytes;
    return true;
  }
  bool end_of_file() {
    fault_ = "the file ends here (the header declares more) give the whole file";
    return false;
  }

  Cursor body_;
  bool swap_;
  std::string fault_;
};

}  // namespace weft::io
