#include "io/mesh.h"

#include "support.h"

namespace weft::io::test::obj_reader {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

Mesh read(const std::string& text) { return read_obj(text, "m.obj"); }
std::string error(const std::string& text) {
  return input_error([&] { read(text); });
}
using Indices = std::vector<uint32_t>;

TEST(ObjReader, ReadsPositionsAndTriangles) {
  const Mesh mesh = read("# a comment\nv 1 -2.5 3e1\nv +.5 0 0\nv 0 0 7 # end\n\nf 1 2 3\n");
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[0].x, 1);
  EXPECT_EQ(mesh.positions[0].y, -2.5);
  EXPECT_EQ(mesh.positions[0].z, 30);
  EXPECT_EQ(mesh.positions[1].x, 0.5);
  EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2}));
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(ObjReader, FansConvexPolygonsFromTheirLowestVertex) {
  const std::string five = triangle + "v 2 1 0\nv 1 2 0\n";
  for (const char* face : {"f 1 2 4 5 3\n", "f 4 5 3 1 2\n", "f -3 -5 -4 -2 -1\n"}) {
    EXPECT_EQ(read(five + face).triangles, (Indices{0, 1, 3, 0, 3, 4, 0, 4, 2})) << face;
  }
}

TEST(ObjReader, AcceptsEveryFormOfCorner) {
  for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1/4/1 2/5/2 3/6/3",
                           "f -3 -2 -1", "f -3/-1/-1 -2//-1 -1/-1", "f +1 +2 +3", "fo 1 2 3"}) {
    EXPECT_EQ(read(triangle + face + "\n").triangles, (Indices{0, 1, 2})) << face;
  }
}

TEST(ObjReader, NegativeIndicesCountBackFromTheFace) {
  const Mesh mesh = read(triangle + "f -3 -2 -1\n" + triangle + "f -3 -2 -1\n");
  EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 3, 4, 5}));
}

TEST(ObjReader, AcceptsFacesBeforeTheirVertices) {
  EXPECT_EQ(read("f 1 2 3\n" + triangle).triangles, (Indices{0, 1, 2}));
}

TEST(ObjReader, CountsVerticesInEveryFormOfLine) {
  const Mesh mesh = read("\xEF\xBB\xBFv 0 0 0\n  v 1 0 0\nv\\\n 1 1 0\n\tv\t0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 6u);
}

TEST(ObjReader, JoinsContinuedLines) {
  const Mesh mesh = read("v 1 \\\n 2 \\\r\n 3\nv 0 0 0\nv 1 1 1\nf 1 \\\n2 3");
  EXPECT_EQ(mesh.positions[0].z, 3);
  EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2}));
  EXPECT_EQ(read("# C:\\\nv 1 2 3\n").positions.size(), 1u) << "comments do not continue";
}

TEST(ObjReader, AcceptsWindowsLineEndsAndByteOrderMark) {
  const Mesh mesh = read("\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n");
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST(ObjReader, SkipsWhatIsNotGeometry) {
  const Mesh mesh = read("mtllib a.mtl\no x\ng y\ns 1\nvt 0 0\nvn 0 0 1\nvp 1\nusemtl m\nl 1 2\n" +
                         triangle + "f 1 2 3\n");
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(ObjReader, CountsUnknownKeywords) {
  const Mesh mesh = read(triangle + "hello 1\nworld\nf 1 2 3\n");
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_CONTAINS(mesh.warnings[0], "2 lines");
  EXPECT_CONTAINS(mesh.warnings[0], "line 4, 'hello'");
}

TEST(ObjReader, AcceptsWeightsAndColours) {
  EXPECT_EQ(read("v 1 2 3 1.0\nv 1 2 3 .5 .5 .5\n").positions.size(), 2u);
}

TEST(ObjReader, ReadsUnderflowAsZeroAndKeepsRepeatedCorners) {
  EXPECT_EQ(read("v 1e-400 2 3\n").positions[0].x, 0);
  EXPECT_EQ(read(triangle + "f 1 1 2\n").triangles, (Indices{0, 0, 1})) << "the library's to judge";
}

TEST(ObjReader, NamesLineAndValueOfBadNumbers) {
  EXPECT_CONTAINS(error("v 0 0 0\nv 1 2x 3\n"), "m.obj: line 2: vertex 2: y '2x' is not a number");
  EXPECT_CONTAINS(error("v 0 0\n"), "z '' is missing");
  EXPECT_CONTAINS(error("v 1 2 nan\n"), "z 'nan' is not finite");
  EXPECT_CONTAINS(error("v inf 2 3\n"), "x 'inf' is not finite");
  EXPECT_CONTAINS(error("v 1 1e999 3\n"), "y '1e999' is not finite");
  EXPECT_CONTAINS(error("v 1 2 3 red\n"), "'red' is not a number");
  EXPECT_CONTAINS(error("v 1 2,5 3\n"), "'2,5' is not a number");
}

TEST(ObjReader, NamesLineAndValueOfBadFaces) {
  EXPECT_CONTAINS(error(triangle + "f 1 2\n"), "line 4: the face has 2 vertices");
  EXPECT_CONTAINS(error(triangle + "f 1 2 4\n"), "line 4: face index 4 is out of range");
  EXPECT_CONTAINS(error(triangle + "f 1 2 9\nf 1 2 7\nf 3 2 9\nl 1 9\n"),
                  "line 4: face index 9 is out of range");  // the first that names the highest
  EXPECT_CONTAINS(error(triangle + "f 1 2 3\nl 1 2 5\nf 1 2 5\n"), "line 5: line index 5");
  EXPECT_CONTAINS(error(triangle + "f 0 1 2\n"), "line 4: face index 0 is out of range");
  EXPECT_CONTAINS(error(triangle + "f -4 1 2\n"), "line 4: face index -4 is out of range");
  EXPECT_CONTAINS(error(triangle + "f 1 2 99999999999\n"), "face index 99999999999");
  EXPECT_CONTAINS(error(triangle + "f 1 2 99999999999999999999999\n"), "is not a number");
  EXPECT_CONTAINS(error(triangle + "f 1 2 x\n"), "face index 'x' is not a number");
  EXPECT_CONTAINS(error(triangle + "f 1 2 3/a\n"), "'3/a'");
  EXPECT_CONTAINS(error(triangle + "f 1 2 3/1/1/1\n"), "'3/1/1/1'");
  EXPECT_CONTAINS(error(triangle + "v 1 1 0\nf 1 2 3 2\n"), "names vertex 2 twice");
  EXPECT_CONTAINS(error(triangle + "f 1 2 3 1\n"),
                  "line 4: the face has more than 3 vertices (the file has no more");
}

TEST(ObjReader, RefusesWhatIsNotObj) {
  EXPECT_CONTAINS(error(""), "has no vertices");
  EXPECT_CONTAINS(error("hello\nworld\n"), "has no vertices");
  EXPECT_CONTAINS(error("f 1 2 3\n"), "has no vertices");
  EXPECT_CONTAINS(error(std::string("\0\1\2\3", 4)), "zero byte");
}

}  // namespace
}  // namespace weft::io::test::obj_reader
