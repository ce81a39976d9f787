// Files that are not meshes, or not files, and meshes that are nonsense.
#include "io/file_text.h"
#include "io/mesh.h"

#include "support.h"

#include <sys/stat.h>

#include <random>

namespace weft::io::test::mesh_file {
namespace {

std::string error(const std::string& path) {
  const std::string message = input_error([&] { read_mesh(path); });
  EXPECT_CONTAINS(message, path);
  return message;
}

TEST(MeshFile, TellsFormatsApartByContentAndName) {
  const TemporaryFolder folder;
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n1 2 3\n";
  EXPECT_EQ(read_mesh(folder.write("ply_inside.obj", ply)).positions.size(), 1u);
  EXPECT_EQ(read_mesh(folder.write("noname", "v 1 2 3\n")).positions.size(), 1u);
  EXPECT_CONTAINS(error(folder.write("not.ply", "v 1 2 3\n")), "does not start with 'ply'");
}

TEST(MeshFile, NamesWhatIsWrongWithTheFile) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(error(folder / "missing.obj"), "cannot be read");
  EXPECT_CONTAINS(error(folder.write("empty.obj", "")), "is empty");
  EXPECT_CONTAINS(error(folder.string()), "is a directory");
  EXPECT_CONTAINS(error(folder.write("file", "v 1 2 3") + "/below.obj"), "cannot be read");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_CONTAINS(error(folder / "pipe"), "is not a regular file");
}

TEST(MeshFile, RefusesAFileLargerThanMemory) {
  const TemporaryFolder folder;
  const std::string path = folder.write("huge.obj", "v 0 0 0\n");
  ASSERT_EQ(::truncate(path.c_str(), off_t(1) << 43), 0);
  EXPECT_CONTAINS(error(path), "8796093022208 bytes");
}

TEST(MeshFile, ReadsLinesThatEndWithACarriageReturn) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("old.obj", "v 1 2 3\rv 4 5 6\r")).positions.size(), 2u);
  const std::string ply =
      "ply\rformat ascii 1.0\relement vertex 1\rproperty float x\r"
      "property float y\rproperty float z\rend_header\r1 2 3\r";
  EXPECT_EQ(read_mesh(folder.write("old.ply", ply)).positions[0].z, 3);
  EXPECT_CONTAINS(error(folder.write("bad.obj", "v 1 2 3\rv 4 5\r")), "line 2");
  EXPECT_EQ(read_mesh(folder.write("mixed.obj", "v 1 2 3\rv 4 5 6\nv 7 8 9\r\nv 1 1 1\r\n"))
                .positions.size(),
            4u);
  // The 13 in a binary file is no end of a line.
  const std::string binary =
      "ply\ncomment ascii\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\n"
      "property uchar y\nproperty uchar z\nend_header\n\r\r\r";
  EXPECT_EQ(read_mesh(folder.write("binary.ply", binary)).positions[0].x, 13);
  EXPECT_EQ(read_mesh(folder.write("blank.ply", "ply " + binary.substr(3))).positions[0].x, 13);
  EXPECT_CONTAINS(error(folder.write("twice.ply", "ply\nformat ascii 1.0\n" + binary.substr(4))),
                  "line 4: the format is given twice");
}

// Limits that a test can reach instead of half of the machine's memory.
TEST(MeshFile, TakesNoMoreMemoryThanItMay) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  const size_t need = vertices.size() + 4 * sizeof(double3);
  EXPECT_EQ(read_obj(vertices, "m.obj", need).positions.size(), 4u);
  EXPECT_CONTAINS(input_error([&] { read_obj(vertices, "m.obj", need - 1); }),
                  "m.obj: line 1: the mesh does not fit from here on (reading may take ");
  const std::string fan = vertices + "f 1 2 4 3\n";
  EXPECT_EQ(read_obj(fan, "m.obj", 4096).triangles.size(), 6u);
  EXPECT_CONTAINS(input_error([&] { read_obj(fan, "m.obj", need + 30); }), "m.obj: line ");
  const std::string joined = vertices + "f 1 2 \\\n" + std::string(9000, ' ') + "3\n";
  EXPECT_CONTAINS(input_error([&] { read_obj(joined, "m.obj", joined.size() + 4000); }),
                  "does not fit");
  EXPECT_EQ(read_obj(joined, "m.obj", joined.size() + 40000).triangles.size(), 3u);

  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 100\nproperty char x\n"
      "property char y\nproperty char z\nelement face 1\n"
      "property list uchar uchar vertex_indices\nend_header\n" +
      std::string("\0\0\0\1\0\0\1\1\0\0\1\0", 12) + std::string(288, '\1') + "\4" +
      std::string("\0\1\2\3", 4);
  EXPECT_EQ(read_ply(ply, "m.ply", 8192).triangles.size(), 6u);
  EXPECT_CONTAINS(input_error([&] { read_ply(ply, "m.ply", ply.size() + 2399); }),
                  "m.ply: vertex 0: the mesh does not fit from here on");
  EXPECT_CONTAINS(input_error([&] { read_ply(ply, "m.ply", ply.size() + 2420); }),
                  "m.ply: face 0: the mesh does not fit from here on");
}

TEST(MeshFile, RandomBytesAreRefused) {
  std::mt19937 random(8);
  const std::string starts[] = {
      "", "v 1 2 3\nf ", "ply\n",
      "ply\nformat binary_little_endian 1.0\nelement vertex 9\n"
      "property double x\nproperty char y\nproperty int z\n"
      "element face 9\nproperty list int uint vertex_index\nend_header\n"};
  for (int round = 0; round < 2000; ++round) {
    std::string text = starts[round % 4];
    for (auto i = random() % 400; i > 0; --i) text += char(random());
    const auto read = round % 4 < 2 ? read_obj : read_ply;
    try {
      const Mesh mesh = read(text, "random", largest_mesh_memory());
      for (const uint32_t v : mesh.triangles) ASSERT_LT(v, mesh.positions.size());
    } catch (const InputError&) {
    }
  }
}

TEST(MeshFile, DamagedMeshesAreReadOrRefused) {
  std::string obj, ply =
                       "ply\nformat ascii 1.0\nelement vertex 20\nproperty float x\n"
                       "property float y\nproperty float z\nelement face 18\n"
                       "property list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 20; ++i) obj += "v 0.5 " + std::to_string(i) + " -1e-3\n";
  for (int i = 0; i < 20; ++i) ply += "0.5 " + std::to_string(i) + " 2\n";
  for (int i = 1; i < 19; ++i) obj += "f " + std::to_string(i) + " 19/1/2 -1\n";
  for (int i = 0; i < 18; ++i) ply += "3 " + std::to_string(i) + " 18 19\n";
  std::mt19937 random(5);
  for (int round = 0; round < 4000; ++round) {
    std::string text = round % 2 ? obj : ply;
    for (auto k = 1 + random() % 3; k > 0; --k) text[random() % text.size()] = char(random());
    try {
      const Mesh mesh = (round % 2 ? read_obj : read_ply)(text, "damaged", largest_mesh_memory());
      for (const uint32_t v : mesh.triangles) ASSERT_LT(v, mesh.positions.size());
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace weft::io::test::mesh_file
