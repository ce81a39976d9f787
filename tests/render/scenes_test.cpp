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

class SamplePictures : public testing::TestWithParam<Sample> {};

TEST_P(SamplePictures, LookAsTheyDid) {
  const std::string name = GetParam().name;
  const std::string file = std::string(WEFT_SAMPLE_SCENES) + "/" + name + ".json";
  const Json scene = Json::parse(io::test::read_text(file));
  const Json& cloth = scene["cloths"][0];
  if (cloth.contains("mesh") &&
      !std::filesystem::exists(cloth["mesh"]["file"].get<std::string>())) {
    GTEST_SKIP() << "the mesh is not on this machine (apt-get install assimp-testmodels)";
  }
  const TemporaryFolder folder;
  const Outcome outcome = run_weft(
      "run --time 1 --every 1 --format png --size 320x180 --out " + folder.string() + " " + file,
      in_software);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Image got = read_png(folder / "frame_000001.png");
  const Image want = read_png(std::string(WEFT_GOLDEN_PICTURES) + "/" + name + ".png");
  ASSERT_EQ(got.width, 320u);
  ASSERT_EQ(got.height, 180u);
  ASSERT_EQ(want.width, 320u) << "there is no golden picture";
  EXPECT_GE(psnr(got, want), 40);
  EXPECT_LT(psnr(got, read_png(folder / "frame_000000.png")), 40) << "as at the start";
}

INSTANTIATE_TEST_SUITE_P(All, SamplePictures,
                         testing::Values(Sample{"flag_in_wind"}, Sample{"flag_on_pole"},
                                         Sample{"patch_on_four_pins"}, Sample{"sheet_on_sphere"},
                                         Sample{"small_network"}, Sample{"wuson_drop"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SamplePictures, EverySampleSceneHasOne) {
  size_t scenes = 0, pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(WEFT_SAMPLE_SCENES)) {
    scenes += entry.path().extension() == ".json";
  }
  for (const auto& entry : std::filesystem::directory_iterator(WEFT_GOLDEN_PICTURES)) {
    pictures += entry.path().extension() == ".png";
  }
  EXPECT_EQ(scenes, 6u) << "a new scene goes into the list above";
  EXPECT_EQ(pictures, scenes);
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

TEST(Pictures, AThinPostThroughASheetIsAWarning) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0.05}};
  json["colliders"] =
      Json::parse(R"([{"capsule": {"a": [0.6, 1, -1], "b": [0.6, 1, 1], "radius": 0.02}}])");
  const std::string run = "run --format png --size 32x32 --out " + folder.string() + " ";
  const Outcome outcome = run_weft(run + folder.write("s.json", json.dump()), in_software);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("s.json: $.colliders[0]: shows through cloth"), std::string::npos)
      << outcome.err;
}

TEST(Pictures, ACameraThatSeesNothingIsAWarning) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0}};
  json["camera"] = {{"eye", {0.5, 1, 4}}, {"target", {0.5, 1, 8}}, {"width", 16}, {"height", 16}};
  const std::string scene = folder.write("s.json", json.dump());
  const Outcome outcome =
      run_weft("run --format png --out " + folder.string() + " " + scene, in_software);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("s.json: $.camera: no cloth is in any picture"), std::string::npos);
  json["camera"]["target"] = {0.5, 1, 0};
  for (const char* wall : {"[]", R"([{"box": {"center": [0.5, 1, 2], "half": [9, 9, 0.1]}}])"}) {
    json["colliders"] = Json::parse(wall);
    const std::string walled = folder.write("w.json", json.dump());
    const Outcome seen =
        run_weft("run --format png --out " + folder.string() + " " + walled, in_software);
    EXPECT_EQ(seen.code, 0);
    EXPECT_EQ(seen.err.find("no cloth is in any picture") != std::string::npos,
              !json["colliders"].empty())
        << seen.err;
  }
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

TEST(Pictures, AClothThatStartsInAColliderIsAWarning) {
  const TemporaryFolder folder;
  Json json = io::test::falling_scene();
  json["time"] = {{"duration", 0}};
  json["colliders"] = Json::parse(R"([{"sphere": {"center": [0.5, 1, 0], "radius": 0.4}}])");
  const std::string run = "run --format png --size 32x32 --out " + folder.string() + " ";
  const Outcome outcome = run_weft(run + folder.write("s.json", json.dump()), in_software);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("s.json: $.colliders[0]: shows through cloth at the start"),
            std::string::npos)
      << outcome.err;
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
