// Files that are not meshes, or not files, and meshes that are nonsense.
#include "io/file_text.h"
#include "io/mesh.h"

#include "support.h"

#include <sys/stat.h>

#include <random>

namespace weft::io::test {
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
      const Mesh mesh = read(text, "random");
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
      const Mesh mesh = (round % 2 ? read_obj : read_ply)(text, "damaged");
      for (const uint32_t v : mesh.triangles) ASSERT_LT(v, mesh.positions.size());
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace weft::io::test
