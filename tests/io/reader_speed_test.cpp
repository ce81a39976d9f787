// The readers at work on a mesh of 100 MB: how fast, and in how much memory.
#include "io/mesh.h"
#include "io/surface.h"

#include "support.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace weft::io::test {
namespace {

constexpr size_t file_size = 100'000'000;
constexpr double least_speed = 100e6;  // bytes/s
constexpr double most_memory = 3;      // times the file

/// The bunny where it is; otherwise the figure that the sample scenes use.
std::string base_mesh() {
  const std::string bunny = WEFT_SHARED_DATA "/stanford-bunny.obj";
  return std::filesystem::exists(bunny) ? bunny : "/usr/share/assimp/models/OBJ/WusonOBJ.obj";
}

/// Side by side as often as fills a file, at `bytes` for a vertex with its two triangles.
Surface repeated(const Mesh& mesh, size_t bytes) {
  Surface surface;
  const size_t copies = file_size / (mesh.positions.size() * bytes) + 1;
  for (size_t copy = 0; copy < copies; ++copy) {
    const auto first = uint32_t(surface.positions.size());
    for (double3 p : mesh.positions) surface.positions.push_back({p.x + double(copy), p.y, p.z});
    for (size_t t = 0; t < mesh.triangles.size(); t += 3) {
      const uint32_t* v = &mesh.triangles[t];
      surface.triangles.push_back({first + v[0], first + v[1], first + v[2]});
    }
  }
  surface.parts = {{"all", 0, surface.positions.size(), 0, surface.triangles.size(), 0, 0}};
  return surface;
}

/// The same as text: scanners write PLY so.
void write_ply_text(const std::string& path, const Surface& surface) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  std::fprintf(file,
               "ply\nformat ascii 1.0\nelement vertex %zu\nproperty float x\nproperty float y\n"
               "property float z\nelement face %zu\nproperty list uchar int vertex_indices\n"
               "end_header\n",
               surface.positions.size(), surface.triangles.size());
  for (double3 p : surface.positions) std::fprintf(file, "%.8g %.8g %.8g\n", p.x, p.y, p.z);
  for (auto t : surface.triangles) std::fprintf(file, "3 %u %u %u\n", t[0], t[1], t[2]);
  ASSERT_EQ(std::fclose(file), 0);
}

struct Reading {
  double seconds = 0;
  size_t bytes = 0;  ///< most that the process took while it read
  size_t vertices = 0;
};

size_t most_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return size_t(usage.ru_maxrss) * 1024;
}

/// In a process of its own, whose memory nothing else has used.
Reading read_alone(const std::string& path) {
  int ends[2];
  Reading reading;
  if (::pipe(ends) != 0) return reading;
  ::malloc_trim(0);  // or the child fills what this process freed
  const pid_t child = ::fork();
  if (child == 0) {
    const size_t before = most_bytes();
    const auto start = std::chrono::steady_clock::now();
    const Mesh mesh = read_mesh(path);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    const Reading mine{took.count(), most_bytes() - before, mesh.positions.size()};
    ::_exit(::write(ends[1], &mine, sizeof mine) == ssize_t(sizeof mine) ? 0 : 1);
  }
  ::close(ends[1]);
  if (::read(ends[0], &reading, sizeof reading) != ssize_t(sizeof reading)) reading = {};
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return reading;
}

enum class Format { obj, ply, ply_text };

std::string name_of(Format format) {
  const char* const names[] = {"obj", "ply", "ply_text"};
  return names[int(format)];
}

class ReaderSpeed : public testing::TestWithParam<Format> {};

TEST_P(ReaderSpeed, ReadsAHundredMegabytesASecondInThriceTheFile) {
  if (!std::filesystem::exists(base_mesh())) GTEST_SKIP() << base_mesh() << " is absent";
  const TemporaryFolder folder;
  const std::string path = folder / "mesh";
  size_t vertices = 0;
  {
    const Surface surface = repeated(read_mesh(base_mesh()), GetParam() == Format::ply ? 38 : 70);
    vertices = surface.positions.size();
    switch (GetParam()) {
      case Format::obj:
        write_obj(path, surface, Precision::float32);
        break;
      case Format::ply:
        write_ply(path, surface, Precision::float32);
        break;
      case Format::ply_text:
        write_ply_text(path, surface);
        break;
    }
  }
  const auto size = double(std::filesystem::file_size(path));
  EXPECT_GT(size, 0.8 * double(file_size));
  double best = 0, memory = 0;
  for (int round = 0; round < 5; ++round) {  // other work on the machine only slows a round
    const Reading reading = read_alone(path);
    ASSERT_EQ(reading.vertices, vertices);
    best = std::max(best, size / reading.seconds);
    memory = std::max(memory, double(reading.bytes) / size);
  }
  std::printf("%s: %.0f MB, %.0f MB/s, %.2f times the file in memory\n",
              name_of(GetParam()).c_str(), size / 1e6, best / 1e6, memory);
  EXPECT_GE(best, least_speed);
  EXPECT_LE(memory, most_memory);
}

INSTANTIATE_TEST_SUITE_P(Formats, ReaderSpeed,
                         testing::Values(Format::obj, Format::ply, Format::ply_text),
                         [](const auto& info) { return name_of(info.param); });

}  // namespace
}  // namespace weft::io::test
