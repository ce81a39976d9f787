#include "io/json_document.h"
#include "io/json_node.h"
#include "io/mesh.h"
#include "io/scene.h"
#include "io/nearest.h"

#include "support.h"

#include <nlohmann/json.hpp>

namespace weft::io::test {
namespace {

std::string error(const std::string& text) {
  return input_error([&] { parse_json(text, "s.json"); });
}

TEST(JsonDocument, ReadsWhatTheParserReads) {
  const std::string text = R"({"a": [1, -2, 2.5, true, null, "x", {"b": []}], "c": {}})";
  EXPECT_EQ(parse_json(text, "s.json"), Json::parse(text));
  EXPECT_EQ(parse_json("7", "s.json"), Json(7));
}

TEST(JsonDocument, RefusesWhatIsNotJson) {
  EXPECT_CONTAINS(error(""), "s.json: is empty");
  EXPECT_CONTAINS(error("{\n\"a\": }"), "line 2");
  EXPECT_CONTAINS(error("{} {}"), "is not JSON");
  EXPECT_CONTAINS(error("{\"a\": NaN}"), "$.a, line 1");
  EXPECT_CONTAINS(error("{\"a\": [0, Infinity]}"), "$.a[1]");
  EXPECT_CONTAINS(error("{\"a\": \"\xFF\"}"), "UTF-8");
  EXPECT_CONTAINS(error("// comment\n{}"), "is not JSON");
  EXPECT_CONTAINS(error(std::string("{}\n\0 {", 6)), "s.json: line 2: has a zero byte");
  EXPECT_CONTAINS(error("{\"a\": [1"), "$.a");
}

TEST(JsonDocument, RefusesOverflow) {
  EXPECT_CONTAINS(error("{\"a\": {\"b\": [1, 1e999]}}"), "$.a.b[1], line 1: 1e999 overflows");
  EXPECT_CONTAINS(error("{\"a\": -1e400}"), "-1e400 overflows");
}

TEST(JsonDocument, RefusesAKeyGivenTwice) {
  EXPECT_CONTAINS(error(R"({"a": [{"b": 1, "c": 2, "b": 3}]})"),
                  "$.a[0].b: the key is given twice");
}

TEST(JsonDocument, RefusesDeepNesting) {
  EXPECT_CONTAINS(error(std::string(100000, '[')), "deeper than 32");
  std::string objects;
  for (int i = 0; i < 1000; ++i) objects += "{\"a\":";
  EXPECT_CONTAINS(error(objects), "deeper than 32");
}

TEST(Node, NamesPathAndValue) {
  const Json json = Json::parse(R"({"list": [{"x": "text", "n": 5, "f": 2.5, "big": 1e300}]})");
  const Node root(json);
  const Node list = root.at("list", "it");
  const Node entry = list[0];
  const auto message = [&](auto call) { return input_error(call); };
  EXPECT_CONTAINS(message([&] { entry.at("x", "it").number(); }),
                  "$.list[0].x: \"text\" has the wrong type (string) give a number");
  EXPECT_CONTAINS(message([&] { entry.at("n", "it").integer(6, 9, "why"); }),
                  "$.list[0].n: 5 is out of range (why) give an integer >= 6 and <= 9");
  EXPECT_CONTAINS(message([&] { entry.at("f", "it").integer(0, 9, "why"); }),
                  "2.5 has the wrong type");
  EXPECT_CONTAINS(message([&] { entry.at("y", "a y"); }), "$.list[0].y: is missing");
  EXPECT_CONTAINS(message([&] { entry.at("n", "it").boolean(); }), "give true or false");
  EXPECT_CONTAINS(message([&] { list.vector(); }), "$.list: an array of 1 is not a vector");
  EXPECT_CONTAINS(message([&] {
                    entry.require_object({"x", "n", "f", "bit"});
                  }),
                  "$.list[0].big: unknown key with the value 1e+300 (known are x, n, f, bit) did "
                  "you mean \"bit\"?");
}

TEST(NearestWord, FindsMisspellings) {
  const std::vector<const char*> known{"stiffness", "rest_length", "damping"};
  EXPECT_EQ(nearest_word("stifness", known), "stiffness");
  EXPECT_EQ(nearest_word("restLength", known), "rest_length");
  EXPECT_EQ(nearest_word("dampign", known), "damping");
  EXPECT_EQ(nearest_word("DAMPING", known), "damping");
  EXPECT_EQ(nearest_word("colour", known), "");
  EXPECT_EQ(nearest_word(std::string(100000, 'x'), known), "");
}

TEST(SceneFile, SizeIsLookedAtBeforeItIsRead) {
  const TemporaryFolder folder;
  const std::string path = folder.write("s.json", "{}");
  std::filesystem::resize_file(path, (uint64_t(1) << 28) + 1);  // a hole: it takes no disk
  EXPECT_CONTAINS(input_error([&] { read_scene(path); }), "has 268435457 bytes (at most ");
  EXPECT_CONTAINS(input_error([&] { read_scene(path); }), " are read on this machine");
}

TEST(MeshFile, SizeIsLookedAtBeforeItIsRead) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", "v 0 0 0");
  std::filesystem::resize_file(path, uint64_t(1) << 42);
  EXPECT_CONTAINS(input_error([&] { read_mesh(path); }), "has 4398046511104 bytes (at most ");
}

}  // namespace
}  // namespace weft::io::test
