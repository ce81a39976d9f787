#include "io/mesh.h"

#include "support.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace weft::io::test::ply_reader {
namespace {

using Indices = std::vector<uint32_t>;

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string face_list = "property list uchar int vertex_indices\n";
std::string header(const std::string& format, size_t vertices, size_t faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) + "\n" + xyz +
         "element face " + std::to_string(faces) + "\n" + face_list + "end_header\n";
}
const std::string three = "0 0 0\n1 0 0\n0 1 0\n";

Mesh read(const std::string& text) { return read_ply(text, "m.ply"); }
std::string error(const std::string& text) {
  return input_error([&] { read(text); });
}

template <class Value>
void put(std::string& out, Value value, bool big) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof value);
  out.append(bytes, sizeof value);
}

TEST(PlyReader, ReadsText) {
  const Mesh mesh = read(header("ascii", 4, 2) + three + "1 1 2.5e0 \n\n4 0 1 3 2\n3 0 1 2");
  EXPECT_EQ(mesh.positions[3].z, 2.5);
  EXPECT_EQ(mesh.triangles, (Indices{2, 0, 1, 2, 1, 3, 0, 1, 2})) << "the shorter diagonal";
}

TEST(PlyReader, ReadsWindowsLineEnds) {
  std::string text = header("ascii", 3, 1) + three + "3 0 1 2\n";
  for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  EXPECT_EQ(read(text).triangles, (Indices{0, 1, 2}));
}

// Every scalar type, lists in front of and behind what counts, an element nobody knows.
std::string all_types(bool big) {
  std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                     "_endian 1.0\ncomment odd but legal\nelement vertex 3\n"
                     "property list uchar short before\nproperty char x\nproperty double y\n"
                     "property uint16 z\nproperty float32 w\n"
                     "element camera 2\nproperty list int float32 matrix\nproperty int8 id\n"
                     "element face 1\nproperty uint flags\nproperty list ushort uint vertex_index\n"
                     "property list char double after\nend_header\n";
  for (int i = 0; i < 3; ++i) {
    put(text, uint8_t(i), big);
    for (int k = 0; k < i; ++k) put(text, int16_t(-k), big);
    put(text, int8_t(-i), big);
    put(text, 0.1 * i, big);
    put(text, uint16_t(60000 + i), big);
    put(text, 1.0f, big);
  }
  for (int i = 0; i < 2; ++i) {
    put(text, int32_t(2), big);
    put(text, 1.0f, big);
    put(text, 2.0f, big);
    put(text, int8_t(7), big);
  }
  put(text, uint32_t(9), big);
  put(text, uint16_t(3), big);
  for (uint32_t v : {2u, 1u, 0u}) put(text, v, big);
  put(text, int8_t(1), big);
  put(text, 1.0, big);
  return text;
}

TEST(PlyReader, ReadsEveryTypeInBothByteOrders) {
  for (const bool big : {false, true}) {
    const Mesh mesh = read(all_types(big));
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.positions[2].x, -2);
    EXPECT_EQ(mesh.positions[2].y, 0.2);
    EXPECT_EQ(mesh.positions[2].z, 60002);
    EXPECT_EQ(mesh.triangles, (Indices{2, 1, 0}));
  }
}

TEST(PlyReader, EveryTruncationIsAnError) {
  for (const bool big : {false, true}) {
    const std::string whole = all_types(big);
    for (size_t size = 0; size < whole.size(); ++size) error(whole.substr(0, size));
  }
  const std::string text = header("ascii", 3, 1) + three + "3 0 1 2\n";
  for (size_t size = 0; size + 3 < text.size(); ++size) error(text.substr(0, size));
}

TEST(PlyReader, SkipsUnknownHeaderLinesWithAWarning) {
  const Mesh mesh =
      read("ply\nformat ascii 1.0\nCreated by Blender\nobj_info x\nelement vertex 1\n" + xyz +
           "end_header\n1 2 3\n");
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_CONTAINS(mesh.warnings[0], "line 3");
  EXPECT_CONTAINS(mesh.warnings[0], "'Created'");
}

TEST(PlyReader, WarnsOfWhatFollowsTheLastElement) {
  const std::string whole = header("ascii", 3, 1) + three + "3 0 1 2\n";
  EXPECT_TRUE(read(whole + " \n\r\n").warnings.empty());
  const Mesh text = read(whole + "\nmore\n");
  ASSERT_EQ(text.warnings.size(), 1u);
  EXPECT_CONTAINS(text.warnings[0], "5 bytes behind the last element were skipped");
  const Mesh binary = read(all_types(true) + "xyz");
  ASSERT_EQ(binary.warnings.size(), 1u);
  EXPECT_CONTAINS(binary.warnings[0], "3 bytes");
}

TEST(PlyReader, AcceptsAPointCloud) {
  EXPECT_TRUE(read("ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "end_header\n1 2 3\n")
                  .triangles.empty());
}

TEST(PlyReader, ChecksCountsBeforeAllocating) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string message = error(header(format, 4000000000, 1) + three);
    EXPECT_CONTAINS(message, "element vertex 4000000000 does not fit in the");
    EXPECT_CONTAINS(error(header(format, 1, 4000000000) + three), "element face 4000000000");
  }
  std::string text = header("binary_little_endian", 1, 1);
  text.replace(text.find("uchar"), 5, "uint");
  text += std::string(12, '\0') + std::string("\xFF\xFF\xFF\xFF") + std::string(20, '\0');
  EXPECT_CONTAINS(error(text), "the list length 4294967295 is more than what is left");
}

TEST(PlyReader, NamesLineElementAndValue) {
  EXPECT_CONTAINS(error(header("ascii", 3, 0) + "0 0 0\n1 nan 0\n0 1 0\n"),
                  "m.ply: line 11: vertex 1: y: 'nan' is not finite");
  EXPECT_CONTAINS(error(header("ascii", 3, 0) + "0 0 0.0000\n1 0\n0 1 0\n"),
                  "line 11: vertex 1: z: '' is missing");
  EXPECT_CONTAINS(error(header("ascii", 3, 0) + "0 0 0\n1 0 0 0\n0 1 0\n"),
                  "line 11: vertex 1: '0' is one value too many");
  EXPECT_CONTAINS(error(header("ascii", 3, 1) + three + "3 0 1 3\n"),
                  "line 13: face 0: vertex index 3 is out of range");
  EXPECT_CONTAINS(error(header("ascii", 3, 1) + three + "3 0 -1 2\n"), "vertex index -1");
  EXPECT_CONTAINS(error(header("ascii", 3, 1) + three + "2 0 1 2\n"), "the face has 2 vertices");
  EXPECT_CONTAINS(error(header("ascii", 3, 1) + three + "3 0 1 x\n"), "'x' is not a number");
  EXPECT_CONTAINS(error(header("ascii", 4, 1) + three + "1 1 0\n4 0 1 2 1\n"),
                  "names vertex 1 twice");
  EXPECT_CONTAINS(error(header("ascii", 3, 1) + three + "4 0 1 2 1\n"),
                  "the face has 4 vertices (the file has 3, so that it names one twice)");
  std::string text = header("binary_big_endian", 1, 0);
  put(text, 0.0f, true);
  put(text, std::numeric_limits<float>::infinity(), true);
  put(text, 0.0f, true);
  EXPECT_CONTAINS(error(text), "vertex 0: y: inf is not finite");
}

TEST(PlyReader, RefusesBadHeaders) {
  const std::string start = "ply\nformat ascii 1.0\n";
  EXPECT_CONTAINS(error(""), "does not start with 'ply' (every PLY file does) give");
  EXPECT_CONTAINS(error("plx\n"), "does not start with 'ply'");
  EXPECT_CONTAINS(error(start), "ends inside the header");
  EXPECT_CONTAINS(error(start + "end_header\n"), "has no vertices");
  EXPECT_CONTAINS(error("ply\nelement vertex 1\n" + xyz + "end_header\n1 2 3\n"), "no format line");
  EXPECT_CONTAINS(error("ply\nformat binary 1.0\n"), "line 2: format 'binary' is unknown");
  EXPECT_CONTAINS(error("ply\nformat ascii 7.3\n"),
                  "line 2: version '7.3' of the format is unknown");
  EXPECT_CONTAINS(error("ply\nformat ascii\n"), "line 2: version '' of the format is unknown");
  std::string properties = start + "element vertex 1\n";
  for (int i = 0; i < 1001; ++i) properties += "property char p" + std::to_string(i) + "\n";
  EXPECT_CONTAINS(error(properties), "line 1004: the element has more than 1000 properties");
  EXPECT_CONTAINS(error(start + "element vertex -1\n"), "the count '-1'");
  EXPECT_CONTAINS(error(start + "element vertex many\n"), "the count 'many'");
  const std::string wrong = error(start + "element vertex 1\n" + xyz + "property float " +
                                  std::string(500, 'n') + "\x01\nend_header\n1.5 2.5 3.5\n");
  EXPECT_CONTAINS(wrong, "nnn...: ");
  EXPECT_LT(wrong.size(), 300u) << "long names are cut";
  EXPECT_CONTAINS(error(start + "property float x\n"), "before any element");
  EXPECT_CONTAINS(error(start + "element vertex 1\nproperty real x\n"), "type 'real' is unknown");
  EXPECT_CONTAINS(error(start + "element vertex 1\nproperty list float int x\n"), "list count");
  EXPECT_CONTAINS(error(start + "element vertex 1\nelement vertex 1\n"), "declared twice");
  EXPECT_CONTAINS(error(start + "element vertex 1\nproperty float x\nend_header\n1\n"),
                  "no number property 'y'");
  EXPECT_CONTAINS(error(start + "element vertex 1\n" + xyz +
                        "element face 1\nproperty int a\n"
                        "end_header\n1 2 3\n1\n"),
                  "no list of integers 'vertex_indices'");
  std::string unknown = start;
  for (int i = 0; i < 200; ++i) unknown += "what\n";
  EXPECT_CONTAINS(error(unknown), "more than 100 unknown lines");
}

}  // namespace
}  // namespace weft::io::test::ply_reader
