// Wavefront OBJ: the lines `v`, `f` and `l`; other known keywords are skipped, unknown ones
// reported.
#include "io/mesh.h"

#include "io/error.h"
#include "io/face_list.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace weft::io {
namespace {

constexpr std::array<std::string_view, 23> skipped_keywords{
    "vt",     "vn",     "vp",     "g",          "o",         "s",        "usemtl",   "mtllib",
    "p",      "usemap", "maplib", "mg",         "bevel",     "c_interp", "d_interp", "lod",
    "cstype", "deg",    "curv",   "shadow_obj", "trace_obj", "bmat",     "step"};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name, uint64_t most_bytes)
      : text_(text), name_(name), most_bytes_(most_bytes), memory_(most_bytes, text.size()) {}
  ObjReader(const ObjReader&) = delete;

  Mesh read() {
    const Cursor begin(text_.substr(0, 3) == "\xEF\xBB\xBF" ? text_.substr(3) : text_);
    reserve(begin);
    Cursor cursor = begin;
    while (cursor.at < cursor.end) {
      line_ = cursor.at;
      read_line(next_logical_line(cursor));
    }
    finish();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail_at(const char* line, const std::string& problem) const {
    const size_t number = line_number(text_, size_t(line - text_.data()));
    throw InputError(name_ + ": line " + std::to_string(number) + ": " + problem);
  }
  [[noreturn]] void fail(const std::string& problem) const { fail_at(line_, problem); }
  void require_room(bool there_is) const {
    if (there_is) return;
    fail("the mesh does not fit from here on (reading may take " + std::to_string(most_bytes_) +
         " bytes on this machine) give a smaller file");
  }

  // A first pass over the line starts is cheap, and growing vectors would need twice the memory.
  void reserve(Cursor cursor) {
    size_t faces = 0, lines = 0;
    line_ = cursor.at;
    while (cursor.at < cursor.end) {
      Cursor line(next_line(cursor));
      skip_blanks(line);
      if (line.end - line.at < 2 || !(is_blank(line.at[1]) || line.at[1] == '\\')) continue;
      most_vertices_ += line.at[0] == 'v';
      faces += line.at[0] == 'f';
      lines += line.at[0] == 'l';
    }
    require_room(memory_.make_room(mesh_.positions, most_vertices_) &&
                 memory_.make_room(mesh_.triangles, 3 * faces) &&
                 memory_.make_room(mesh_.lines, lines));
  }

  // Joins lines that end with a backslash; comments do not continue (they hold Windows paths).
  std::string_view next_logical_line(Cursor& cursor) {
    std::string_view line = without_return(next_line(cursor));
    if (line.empty() || line.back() != '\\' || line.front() == '#') return line;
    joined_.clear();
    while (!line.empty() && line.back() == '\\') {
      require_room(memory_.make_room(joined_, line.size() + 1));
      joined_.append(line.substr(0, line.size() - 1)) += ' ';
      line = without_return(next_line(cursor));
    }
    require_room(memory_.make_room(joined_, line.size()));
    joined_.append(line);
    return joined_;
  }

  static std::string_view without_return(std::string_view line) {
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  void read_line(std::string_view line) {
    Cursor cursor(line);
    const std::string_view keyword = next_word(cursor);
    if (keyword.empty() || keyword[0] == '#') return;
    if (keyword == "v") return read_vertex(cursor);
    if (keyword == "f" || keyword == "fo") return read_face(cursor);
    if (keyword == "l") return read_polyline(cursor);
    for (const auto known : skipped_keywords) {
      if (keyword == known) return;
    }
    unknown_keyword(keyword);
  }

  void unknown_keyword(std::string_view keyword) {
    if (keyword.find('\0') != std::string_view::npos) {
      fail(quoted(keyword) + " has a zero byte (the file is not text) give an OBJ or PLY file");
    }
    if (unknown_lines_++ == 0) {
      first_unknown_ = "line " + std::to_string(line_number(text_, size_t(line_ - text_.data()))) +
                       ", " + quoted(keyword);
    }
  }

  void read_vertex(Cursor& cursor) {
    double3 position{};
    read_coordinate(cursor, "x", position.x);
    read_coordinate(cursor, "y", position.y);
    read_coordinate(cursor, "z", position.z);
    // A weight or a colour may follow.
    for (double ignored = 0; !at_end(cursor) && *cursor.at != '#';) {
      read_coordinate(cursor, "an extra value", ignored);
    }
    require_room(memory_.make_room(mesh_.positions, 1));
    mesh_.positions.push_back(position);
  }

  void read_coordinate(Cursor& cursor, const char* which, double& value) const {
    const NumberFault fault = next_real(cursor, value);
    if (fault == NumberFault::none) return;
    fail("vertex " + std::to_string(mesh_.positions.size() + 1) + ": " + which + " " +
         quoted(next_word(cursor)) + " " + to_text(fault));
  }

  void read_face(Cursor& cursor) {
    read_corners(cursor, "face");
    if (polygon_.size() < 3) {
      fail("the face has " + std::to_string(polygon_.size()) +
           " vertices (a face needs at least three) correct or remove it");
    }
    if (polygon_.size() > std::max<size_t>(most_vertices_, 3)) {
      fail("the face has more than " + std::to_string(most_vertices_) +
           " vertices (the file has no more, so that it names one twice) correct it");
    }
    if (polygon_.size() > 3) {
      scratch_.clear();
      require_room(memory_.make_room(scratch_, polygon_.size()));
      scratch_ = polygon_;
      if (const uint32_t* twice = repeated_vertex(scratch_)) {
        fail("the face names vertex " + std::to_string(*twice + 1) +
             " twice (its triangles would overlap) remove one of the two");
      }
    }
    require_cut(faces_.add(polygon_, line_));
  }

  void require_cut(Cut cut) const {
    if (cut == Cut::done) return;
    const FaceList::Failure& failure = faces_.failure();
    require_room(cut != Cut::no_memory);
    fail_at(failure.line, "the face (number " + std::to_string(failure.face) + " from 0) " +
                              to_text(cut, failure.corners));
  }

  // A line through more than two vertices is as many edges.
  void read_polyline(Cursor& cursor) {
    read_corners(cursor, "line");
    if (polygon_.size() < 2) {
      fail("the line has " + std::to_string(polygon_.size()) +
           " vertices (a line needs at least two) correct or remove it");
    }
    require_room(memory_.make_room(mesh_.lines, polygon_.size() - 1));
    for (size_t k = 1; k < polygon_.size(); ++k) {
      if (polygon_[k - 1] == polygon_[k]) {
        fail("the line joins vertex " + std::to_string(polygon_[k] + 1) +
             " to itself (a spring has two ends) correct or remove it");
      }
      mesh_.lines.push_back({polygon_[k - 1], polygon_[k]});
    }
  }

  void read_corners(Cursor& cursor, const char* kind) {
    polygon_.clear();
    while (!at_end(cursor) && *cursor.at != '#') {
      require_room(memory_.make_room(polygon_, 1));
      polygon_.push_back(next_corner(cursor, kind));
    }
  }

  // `v`, `v/vt`, `v//vn` or `v/vt/vn`; only v matters.
  uint32_t next_corner(Cursor& cursor, const char* kind) {
    const std::string_view word = next_word(cursor);
    const char* end = word.data() + word.size();
    int64_t index = 0;
    const auto [stop, code] = std::from_chars(word.data() + (word[0] == '+'), end, index);
    if (code != std::errc{} || !is_reference_tail(stop, end)) {
      fail(kind + (" index " + quoted(word)) +
           " is not a number (v, v/vt, v//vn or v/vt/vn) correct it");
    }
    return checked_index(index, kind);
  }

  static bool is_reference_tail(const char* at, const char* end) {
    if (at == end) return true;
    if (*at != '/') return false;
    int slashes = 0;
    for (; at < end; ++at) {
      if (*at == '/')
        ++slashes;
      else if (*at != '-' && *at != '+' && (*at < '0' || *at > '9'))
        return false;
    }
    return slashes <= 2;
  }

  // Positive indices may name a vertex that comes later in the file, so they wait for finish().
  uint32_t checked_index(int64_t index, const char* kind) {
    const auto before = int64_t(mesh_.positions.size());
    if (index == 0 || index < -before || index > int64_t(UINT32_MAX)) {
      fail(kind + (" index " + std::to_string(index)) + " is out of range (" +
           std::to_string(before) +
           " vertices so far; indices start at 1, or at -1 backwards) correct it");
    }
    if (index < 0) return uint32_t(before + index);
    if (uint64_t(index) > highest_) {
      highest_ = uint64_t(index);
      highest_line_ = line_;
      highest_kind_ = kind;
    }
    return uint32_t(index - 1);
  }

  void finish() {
    const size_t count = mesh_.positions.size();
    if (count == 0) {
      throw InputError(name_ + ": has no vertices (no line starts with 'v', " +
                       std::to_string(unknown_lines_) +
                       " lines are not OBJ) give an OBJ or PLY file");
    }
    if (highest_ > count) {
      fail_at(highest_line_, highest_kind_ + (" index " + std::to_string(highest_)) +
                                 " is out of range (the file has " + std::to_string(count) +
                                 " vertices) correct it");
    }
    require_cut(faces_.finish());
    if (unknown_lines_ > 0) {
      mesh_.warnings.push_back(
          std::to_string(unknown_lines_) +
          " lines with an unknown keyword were skipped, the first: " + first_unknown_);
    }
  }

  std::string_view text_;
  const std::string& name_;
  uint64_t most_bytes_;
  MemoryLimit memory_;
  Mesh mesh_;
  const char* line_ = nullptr;
  std::string joined_;
  FaceList faces_{mesh_, memory_};
  Polygon polygon_, scratch_;
  uint64_t highest_ = 0;
  const char* highest_line_ = nullptr;
  const char* highest_kind_ = "face";
  size_t most_vertices_ = 0;  ///< lines that may be a vertex
  size_t unknown_lines_ = 0;
  std::string first_unknown_;
};

}  // namespace

Mesh read_obj(std::string_view text, const std::string& name, uint64_t most_bytes) {
  return ObjReader(text, name, most_bytes).read();
}

}  // namespace weft::io
