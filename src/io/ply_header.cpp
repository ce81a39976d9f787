#include "io/ply_header.h"

#include "io/error.h"
#include "io/text_cursor.h"

#include <array>
#include <optional>
#include <utility>

namespace weft::io {
namespace {

std::optional<PlyType> type_named(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{
      {{"char", PlyType::int8},
       {"int8", PlyType::int8},
       {"uchar", PlyType::uint8},
       {"uint8", PlyType::uint8},
       {"short", PlyType::int16},
       {"int16", PlyType::int16},
       {"ushort", PlyType::uint16},
       {"uint16", PlyType::uint16},
       {"int", PlyType::int32},
       {"int32", PlyType::int32},
       {"uint", PlyType::uint32},
       {"uint32", PlyType::uint32},
       {"float", PlyType::float32},
       {"float32", PlyType::float32},
       {"double", PlyType::float64},
       {"float64", PlyType::float64}}};
  for (const auto& [name, type] : names) {
    if (name == word) return type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  PlyHeader read() {
    Cursor cursor(text_);
    if (next_word_of_line(cursor) != "ply")
      fail("does not start with 'ply' (every PLY file does)", "give a PLY file");
    while (cursor.at < cursor.end) {
      ++line_;
      Cursor line(next_line(cursor));
      const std::string_view keyword = next_word(line);
      if (keyword == "end_header") {
        header_.body = size_t(cursor.at - text_.data());
        finish();
        return std::move(header_);
      }
      read_line(keyword, line);
    }
    fail("the file ends inside the header (no line end_header)", "give the whole file");
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw InputError(name_ + ": line " + std::to_string(line_) + ": " + problem + " " + remedy);
  }

  std::string_view next_word_of_line(Cursor& cursor) {
    Cursor line(next_line(cursor));
    return next_word(line);
  }

  void read_line(std::string_view keyword, Cursor& line) {
    if (keyword == "format") return read_format(line);
    if (keyword == "element") return read_element(line);
    if (keyword == "property") return read_property(line);
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return;
    if (keyword.find('\0') != std::string_view::npos) {
      fail("the header has a zero byte (it is text)", "give a PLY file");
    }
    // Old Blender versions write a bare "Created by" line.
    header_.warnings.push_back("line " + std::to_string(line_) + ": the header keyword " +
                               quoted(keyword) + " is unknown, the line was skipped");
    if (header_.warnings.size() > 100) {
      fail("the header has more than 100 unknown lines (is it PLY?)", "give a PLY file");
    }
  }

  void read_format(Cursor& line) {
    if (has_format_) fail("the format is given twice (only one can hold)", "remove one of the two");
    has_format_ = true;
    const std::string_view word = next_word(line);
    if (word == "ascii")
      header_.format = PlyFormat::ascii;
    else if (word == "binary_little_endian")
      header_.format = PlyFormat::little_endian;
    else if (word == "binary_big_endian")
      header_.format = PlyFormat::big_endian;
    else
      fail("format " + quoted(word) +
               " is unknown (ascii, binary_little_endian or "
               "binary_big_endian)",
           "correct it");
    const std::string_view version = next_word(line);
    if (version != "1.0")
      fail("version " + quoted(version) + " of the format is unknown (1.0 is the only one)",
           "write 'format " + std::string(word) + " 1.0'");
  }

  void read_element(Cursor& line) {
    PlyElement element;
    element.name = next_word(line);
    int64_t count = 0;
    if (element.name.empty())
      fail("an element has no name (its kind is told by it)", "write 'element NAME COUNT'");
    Cursor count_at = line;
    const NumberFault fault = next_integer(line, count);
    if (fault != NumberFault::none || count < 0) {
      fail("element " + io::quoted(element.name) + ": the count " + quoted(next_word(count_at)) +
               " is not a whole number >= 0 (it counts records)",
           "correct it");
    }
    if (header_.find(element.name)) {
      fail("element " + io::quoted(element.name) +
               " is declared twice (their records could not be told apart)",
           "remove one of the two");
    }
    if (header_.elements.size() == 1000)
      fail("more than 1000 elements (no mesh has them)", "give a simpler file");
    element.count = uint64_t(count);
    header_.elements.push_back(std::move(element));
  }

  PlyType read_type(Cursor& line) const {
    const std::string_view word = next_word(line);
    const auto type = type_named(word);
    if (!type)
      fail("property type " + quoted(word) + " is unknown (its size is not known)",
           "use one of PLY's eight types");
    return *type;
  }

  void read_property(Cursor& line) {
    if (header_.elements.empty())
      fail("a property stands before any element (it belongs to one)", "reorder them");
    PlyProperty property;
    const Cursor type_at = line;
    property.is_list = next_word(line) == "list";
    if (property.is_list) {
      property.count_type = read_type(line);
      if (!is_integer(property.count_type))
        fail("a list count is not an integer type (it counts values)", "correct it");
    } else {
      line = type_at;
    }
    property.type = read_type(line);
    property.name = next_word(line);
    if (property.name.empty())
      fail("a property has no name (x, y and z are found by it)", "write 'property TYPE NAME'");
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (properties.size() == 1000)
      fail("the element has more than 1000 properties (no mesh has them)", "give a simpler file");
    properties.push_back(std::move(property));
  }

  void finish() const {
    if (!has_format_)
      fail("the header has no format line (text or binary?)", "add 'format ascii 1.0'");
  }

  std::string_view text_;
  const std::string& name_;
  PlyHeader header_;
  size_t line_ = 1;
  bool has_format_ = false;
};

}  // namespace

uint64_t PlyElement::least_bytes(PlyFormat format) const {
  uint64_t bytes = 0;
  for (const auto& property : properties) {
    // In text a value takes a digit and a blank or the end of its line.
    if (format == PlyFormat::ascii)
      bytes += 2;
    else
      bytes += size_of(property.is_list ? property.count_type : property.type);
  }
  return bytes;
}

size_t PlyElement::find(std::string_view property) const {
  size_t i = 0;
  while (i < properties.size() && properties[i].name != property) ++i;
  return i;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  for (const auto& candidate : elements) {
    if (candidate.name == element) return &candidate;
  }
  return nullptr;
}

PlyHeader read_ply_header(std::string_view text, const std::string& name) {
  return HeaderReader(text, name).read();
}

}  // namespace weft::io
