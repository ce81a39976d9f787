// The sample scenes as pictures, compared with those that were looked at and kept in golden/.
// scripts/golden_pictures.sh makes them anew.
#include "../io/cli_support.h"
#include "png_reader.h"

#include <chrono>

namespace weft::render::test {
namespace {

using io::test::Json;
using io::test::Outcome;
using io::test::run_weft;
using io::test::TemporaryFolder;

// The same renderer everywhere, GPU or not. Mesa's driver is unloaded with a few bytes that it
// never frees; LeakSanitizer cannot name a module that is gone, so it does not look here.
const char* const in_software = "LIBGL_ALWAYS_SOFTWARE=1 ASAN_OPTIONS=detect_leaks=0 exec ";

struct Sample {
  const char* name;
  friend void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }
};

/// How much redder than blue a picture is where it is the most: cloth by 50 and more, all else less
/// than 15. `border`: looks at its outermost pixels only.
int reddest(const Image& image, bool border) {
  int most = -255;
  for (uint32_t y = 0; y < image.height; ++y) {
    const bool whole = !border || y == 0 || y + 1 == image.height;
    for (uint32_t x = 0; x < image.width; x += whole ? 1 : image.width - 1) {
      const uint8_t* pixel = &image.rgb[3 * (size_t(y) * image.width + x)];
      most = std::max(most, pixel[0] - pixel[2]);
    }
  }
  return most;
}

class SamplePictures : public testing::TestWithParam<Sample> {};

TEST_P(SamplePictures, LookAsTheyDid) {
  const std::string name = GetParam().name;
  const std::string file = std::string(WEFT_SAMPLE_SCENES) + "/" + name + ".json";
  if (io::test::sample_scene(file).is_null()) {
    GTEST_SKIP() << "the mesh is not on this machine (apt-get install assimp-testmodels)";
  }
  const TemporaryFolder folder;
  const Outcome outcome =
      run_weft("run --threads 1 --time 1 --every 0.25 --format png --size 320x180 --out " +
                   folder.string() + " " + file,
               in_software);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Image got = read_png(folder / "frame_000004.png");
  const Image want = read_png(std::string(WEFT_GOLDEN_PICTURES) + "/" + name + ".png");
  ASSERT_EQ(got.width, 320u);
  ASSERT_EQ(got.height, 180u);
  ASSERT_EQ(want.width, 320u) << "there is no golden picture";
  EXPECT_GE(psnr(got, want), 40);
  EXPECT_LT(psnr(got, read_png(folder / "frame_000000.png")), 40) << "as at the start";
  for (int frame = 0; frame <= 4; ++frame) {
    const Image image = read_png(folder / ("frame_00000" + std::to_string(frame) + ".png"));
    EXPECT_GT(reddest(image, false), 50) << frame;
    EXPECT_LT(reddest(image, true), 15) << frame << ": cloth is cut off";
  }
}

INSTANTIATE_TEST_SUITE_P(All, SamplePictures,
                         testing::Values(Sample{"balls"}, Sample{"flag_in_wind"},
                                         Sample{"flag_on_pole"}, Sample{"patch_on_four_pins"},
                                         Sample{"sheet_on_sphere"}, Sample{"skirt"},
                                         Sample{"small_network"}, Sample{"stack"},
                                         Sample{"two_cloths"}, Sample{"wuson_drop"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SamplePictures, EverySampleSceneHasOne) {
  size_t scenes = 0, pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(WEFT_SAMPLE_SCENES)) {
    scenes += entry.path().extension() == ".json";
  }
  for (const auto& entry : std::filesystem::directory_iterator(WEFT_GOLDEN_PICTURES)) {
    pictures += entry.path().extension() == ".png";
  }
  EXPECT_EQ(scenes, 11u) << "a new scene goes into the list above";
  EXPECT_EQ(pictures + 1, scenes) << "all but fold, which takes minutes with a sanitizer";
}

TEST(Pictures, SameSceneSamePixels) {
  const TemporaryFolder folder;
  const std::string scene = std::string(WEFT_SAMPLE_SCENES) + "/small_network.json";
  for (const char* threads : {"1", "3"}) {
    const Outcome outcome = run_weft("run --time 0.2 --every 0.2 --format png --out " +
                                         (folder / threads) + " --threads " + threads + " " + scene,
                                     in_software);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  const Image one = read_png(folder / "1/frame_000001.png");
  EXPECT_EQ(one.width, 640u);
  EXPECT_EQ(one.rgb, read_png(folder / "3/frame_000001.png").rgb);
}

TEST(Pictures, CameraAndSizeAreTheScenes) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0}};
  json["camera"] = {{"eye", {0.5, 1, 4}}, {"target", {0.5, 1, 0}}, {"width", 65}, {"height", 33}};
  const std::string scene = folder.write("s.json", json.dump());
  const std::string run = "run --format png --out " + folder.string() + " " + scene;
  ASSERT_EQ(run_weft(run, in_software).code, 0);
  const Image seen = read_png(folder / "frame_000000.png");
  EXPECT_EQ(seen.width, 65u);
  EXPECT_EQ(seen.height, 33u);
  json["camera"]["target"] = {0.5, 1, 8};
  folder.write("s.json", json.dump());
  ASSERT_EQ(run_weft(run, in_software).code, 0);
  EXPECT_LT(psnr(seen, read_png(folder / "frame_000000.png")), 30) << "it looks away";
}

TEST(Pictures, PlanesHideNothingFromBehind) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0}};
  json["camera"] = {{"eye", {0.5, 1, 4}}, {"target", {0.5, 1, 0}}, {"width", 64}, {"height", 64}};
  const auto picture = [&](const char* colliders) {
    json["colliders"] = Json::parse(colliders);
    const std::string scene = folder.write("s.json", json.dump());
    const Outcome outcome =
        run_weft("run --format png --out " + folder.string() + " " + scene, in_software);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_png(folder / "frame_000000.png");
  };
  const Image open = picture("[]");
  const char* const behind = R"([{"plane": {"normal": [0, 0, -1], "offset": -2}}])";
  const char* const before = R"([{"plane": {"normal": [0, 0, 1], "offset": -0.5}}])";
  EXPECT_GE(psnr(picture(behind), open), 60);
  EXPECT_LT(psnr(picture(before), open), 30) << "a wall that faces the camera is drawn";
}

// From below the floor no ground is drawn, and what is in front still hides what is behind.
TEST(Pictures, WhatIsNearHidesWhatIsFarAlsoFromBelow) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0}};
  json["colliders"] = Json::parse(R"([{"sphere": {"center": [0.5, 1, -0.6], "radius": 0.2}}])");
  for (const double height : {1.5, -1.5}) {
    json["camera"] = {{"eye", {0.5, height, 4}},
                      {"target", {0.5, 1, 0}},
                      {"width", 64},
                      {"height", 64},
                      {"field_of_view", 20}};
    const std::string scene = folder.write("s.json", json.dump());
    ASSERT_EQ(run_weft("run --format png --out " + folder.string() + " " + scene, in_software).code,
              0);
    const Image seen = read_png(folder / "frame_000000.png");
    const uint8_t* middle = &seen.rgb[3 * (32 * 64 + 32)];
    EXPECT_GT(std::abs(middle[0] - middle[2]), 15) << height << ": a grey ball before the cloth";
  }
}

// A sheet of four particles through which a ball sticks, and one that lies on a box.
TEST(Pictures, CollidersAreWhereTheyAreAndClothIsBeforeThem) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0}};
  json["camera"] = {{"eye", {0.5, 1.5, 4}},
                    {"target", {0.5, 1.5, 0}},
                    {"width", 64},
                    {"height", 64},
                    {"field_of_view", 30}};
  const auto middle = [&](const char* colliders) {
    json["colliders"] = Json::parse(colliders);
    const std::string scene = folder.write("s.json", json.dump());
    EXPECT_EQ(run_weft("run --format png --out " + folder.string() + " " + scene, in_software).code,
              0);
    const Image seen = read_png(folder / "frame_000000.png");
    const uint8_t* pixel = &seen.rgb[3 * (32 * 64 + 32)];
    return std::abs(pixel[0] - pixel[2]);
  };
  const int cloth = middle("[]");
  EXPECT_GT(cloth, 15);
  EXPECT_EQ(middle(R"([{"box": {"center": [0.5, 1.5, -0.5], "half": [0.5, 0.5, 0.5]}}])"), cloth);
  EXPECT_LT(middle(R"([{"sphere": {"center": [0.5, 1.5, 0], "radius": 0.1}}])"), 15);
}

// Without a plane that faces up, the floor goes down with what falls.
TEST(Pictures, TheFloorHidesNothing) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 2}, {"frame", 1}};
  json["camera"] = {{"eye", {0.5, -16, 40}},
                    {"target", {0.5, -18, 0}},
                    {"width", 64},
                    {"height", 64},
                    {"field_of_view", 10}};
  const std::string scene = folder.write("s.json", json.dump());
  ASSERT_EQ(run_weft("run --format png --out " + folder.string() + " " + scene, in_software).code,
            0);
  const Image seen = read_png(folder / "frame_000002.png");
  EXPECT_GT(reddest(seen, false), 50) << "the cloth, 20 m below its start";
}

TEST(Pictures, WhatIsBelowTheGroundCastsNoShadow) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0}};
  json["cloths"][0]["transform"] = {{"translate", {0, 0.3, 0}}};
  json["camera"] = {{"eye", {3, 3, 4}}, {"target", {0.5, 0.5, 0}}, {"width", 64}, {"height", 64}};
  const auto picture = [&](double height) {
    json["colliders"] = Json::parse(R"([{"plane": {"normal": [0, 1, 0], "offset": 0}}, {}])");
    json["colliders"][1]["sphere"] = {{"center", {0.5, height, 0.5}}, {"radius", 0.3}};
    const std::string scene = folder.write("s.json", json.dump());
    EXPECT_EQ(run_weft("run --format png --out " + folder.string() + " " + scene, in_software).code,
              0);
    return read_png(folder / "frame_000000.png");
  };
  const Image buried = picture(-0.31);
  EXPECT_GE(psnr(buried, picture(-0.5)), 45) << "35 where both are seen through the ground";
  EXPECT_LT(psnr(buried, picture(0.1)), 30) << "half of it is above";
}

TEST(Pictures, FilmsNeedFfmpegAndLeaveNothingWithout) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("s.json", io::test::falling_scene().dump());
  const std::string run = "run --format mp4 --out " + (folder / "f") + " " + scene;
  const std::string program = std::string("PATH=/nowhere ") + in_software;
  const Outcome without = run_weft(run, program);
  EXPECT_EQ(without.code, 4);
  EXPECT_NE(without.err.find("films cannot be made (ffmpeg"), std::string::npos) << without.err;
  EXPECT_EQ(folder.file_count(), 1u);
  if (std::system("command -v ffmpeg >/dev/null") != 0) return;
  ASSERT_EQ(run_weft(run, in_software).code, 0);
  EXPECT_GT(std::filesystem::file_size(folder / "f/s.mp4"), 1000u);
  EXPECT_EQ(folder.file_count(), 2u);
  const std::string good = io::test::read_text(folder / "f/s.mp4");
  const Outcome full = run_weft(run, std::string("ulimit -f 2; ") + in_software);
  EXPECT_EQ(full.code, 3) << "a disk that fills up at the end of the film";
  EXPECT_EQ(io::test::read_text(folder / "f/s.mp4"), good);
  EXPECT_EQ(folder.file_count(), 2u);
  // Names that ffmpeg would take for a protocol or an option.
  for (const char* name : {"a:b", "-d"}) {
    EXPECT_EQ(
        run_weft("run --format mp4 --size 32x32 --time 0.02 --out=" + (folder / name) + " " + scene,
                 in_software)
            .code,
        0);
    EXPECT_TRUE(std::filesystem::exists(folder / name + "/s.mp4"));
  }
}

}  // namespace
}  // namespace weft::render::test
