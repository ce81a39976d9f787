#include "io/csv_writer.h"
#include "io/mesh.h"
#include "io/output_file.h"
#include "io/report.h"
#include "io/surface.h"

#include "support.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <csignal>
#include <limits>

namespace weft::io::test {
namespace {

Surface two_parts() {
  Surface surface;
  surface.positions = {{0.1, 1.0 / 3, -1e-30}, {1, 0, 0}, {0, 1e20, 0}, {5, 6, 7}, {8, 9, 10}};
  surface.triangles = {{0, 1, 2}};
  surface.edges = {{3, 4}};
  surface.parts = {{"sheet\nx", 0, 3, 0, 1, 0, 0}, {"net", 3, 2, 1, 0, 0, 1}};
  return surface;
}

void expect_round_trip(const std::string& path, Precision precision) {
  const Surface surface = two_parts();
  const Mesh mesh = read_mesh(path);
  ASSERT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.triangles, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_TRUE(mesh.warnings.empty());
  for (size_t i = 0; i < 5; ++i) {
    const double x = surface.positions[i].x, y = surface.positions[i].y;
    const bool single = precision == Precision::float32;
    EXPECT_EQ(float(mesh.positions[i].x), float(x));
    EXPECT_EQ(float(mesh.positions[i].y), float(y));
    EXPECT_TRUE(single || mesh.positions[i].y == y);
  }
}

TEST(MeshWriters, KeepEveryBitOfThePrecision) {
  const TemporaryFolder folder;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    write_obj(folder / "a.obj", two_parts(), precision);
    expect_round_trip(folder / "a.obj", precision);
    write_ply(folder / "a.ply", two_parts(), precision);
    expect_round_trip(folder / "a.ply", precision);
  }
  EXPECT_EQ(folder.file_count(), 2u) << "no temporary file stays";
}

TEST(MeshWriters, ObjHasAnObjectPerClothAndLinesForNetworks) {
  const TemporaryFolder folder;
  write_obj(folder / "a.obj", two_parts(), Precision::float32);
  const std::string text = read_text(folder / "a.obj");
  EXPECT_CONTAINS(text, "o sheet_x\nv 0.1 0.33333334 -1e-30\n");
  EXPECT_CONTAINS(text, "f 1 2 3\no net\n");
  EXPECT_CONTAINS(text, "l 4 5\n");
}

TEST(FinalWriter, WritesSeventeenDigits) {
  const TemporaryFolder folder;
  const std::vector<double3> x{{0.1, -0.0, 1e22}}, v{{1.0 / 3, 5e-324, 2}};
  FinalWriter writer(folder / "f.csv");
  writer.add_cloth(0, x, v);
  writer.add_cloth(1, v, x);
  EXPECT_FALSE(std::filesystem::exists(folder / "f.csv")) << "nothing before commit";
  writer.commit();
  char line[400];
  std::snprintf(line, sizeof line, "0,0,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", 0.1, -0.0, 1e22,
                1.0 / 3, 5e-324, 2.0);
  const std::string text = read_text(folder / "f.csv");
  EXPECT_EQ(text.substr(0, 28), "cloth,vertex,x,y,z,vx,vy,vz\n");
  EXPECT_CONTAINS(text, line);
  EXPECT_CONTAINS(text, "\n1,0,");
}

TEST(OutputFile, AppearsOnCommitAndReplaces) {
  const TemporaryFolder folder;
  folder.write("x", "old");
  {
    OutputFile file(folder / "x");
    file.write("new");
  }
  EXPECT_EQ(read_text(folder / "x"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
  OutputFile file(folder / "x", Sync::yes);
  file.write("new");
  file.commit();
  EXPECT_EQ(read_text(folder / "x"), "new");
}

TEST(OutputFile, FollowsLinksAndWritesDevicesDirectly) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("target", folder / "link");
  OutputFile file(folder / "link");
  file.write("text");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_text(folder / "target"), "text");
  OutputFile null("/dev/null");
  null.write("text");
  null.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(OutputFile, FailsWithoutATrace) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "x");
  EXPECT_THROW(OutputFile(file + "/below"), OutputError);
  EXPECT_THROW(OutputFile(folder / "no/such/folder"), OutputError);
  EXPECT_THROW(OutputFile(folder.string()), OutputError);
  EXPECT_THROW(OutputFile(""), OutputError);
  EXPECT_THROW(make_folder(file + "/below"), OutputError);
  EXPECT_THROW(make_folder(file), OutputError);
  EXPECT_THROW(probe_output(file + "/below"), OutputError);
  probe_output(folder / "probe");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(OutputFile, FullDeviceIsAnError) {
  OutputFile file("/dev/full");
  file.write("text");
  EXPECT_THROW(file.commit(), OutputError);
}

TEST(OutputFile, FullDiskLeavesNothing) {
  const TemporaryFolder folder;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ::getrlimit(RLIMIT_FSIZE, &old_limit);
  const rlimit small{100000, old_limit.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(
      {
        OutputFile file(folder / "big");
        for (int i = 0; i < 100; ++i) file.write(std::string(10000, 'x'));
        file.commit();
      },
      OutputError);
  ::setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(Report, HasTheKeysOfThePage) {
  Report report;
  report.particles = 10;
  report.steps = 100;
  report.wall_seconds = 1e-6;
  report.dt_bound = std::numeric_limits<double>::infinity();
  report.state_hash = 0xABC;
  report.asleep = 2;
  report.events.push_back({"non_finite", 0, 3, 0.5, "text"});
  const auto json = to_json(report);
  for (const char* key : {"backend",     "device",
                          "threads",     "isa",
                          "precision",   "evaluation",
                          "particles",   "springs",
                          "frames",      "substeps_per_frame",
                          "dt",          "dt_bound",
                          "steps",       "wall_seconds",
                          "cpu_seconds", "ns_per_particle_step",
                          "phases",      "bytes_state",
                          "bytes_total", "events",
                          "energy",      "momentum",
                          "state_hash",  "asleep"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_TRUE(json["dt_bound"].is_null());
  EXPECT_EQ(json["ns_per_particle_step"], 1.0);
  EXPECT_EQ(json["state_hash"], "0000000000000abc");
  EXPECT_EQ(json["events"][0]["vertex"], 3);
  EXPECT_EQ(json["energy"]["kinetic"], 0);
  EXPECT_EQ(json["asleep"], 2);
}

}  // namespace
}  // namespace weft::io::test
