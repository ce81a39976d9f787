// A small valid scene, and what the reader says to changed ones.
#pragma once

#include "io/scene.h"

#include "support.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace weft::io::test {

using Json = nlohmann::json;

inline Json grid_cloth() {
  return Json::parse(R"({ "name": "sheet", "mass": 1, "stiffness": 100,
    "grid": { "rows": 3, "columns": 4, "width": 1, "height": 2, "stencil": "seed12" } })");
}
inline Json network_cloth() {
  return Json::parse(R"({ "name": "net", "mass": 1, "stiffness": 100,
    "network": { "positions": [[0,0,0],[1,0,0],[1,1,0]],
                 "springs": [[0,1],[1,2,50],[0,2,50,1.5]] } })");
}
inline Json scene_of(const Json& cloth) { return {{"weft", 1}, {"cloths", Json::array({cloth})}}; }
inline Scene read_json(const Json& json) { return read_scene_text(json.dump(), "s.json"); }
inline ClothScene read_cloth_json(const Json& cloth) {
  return read_json(scene_of(cloth)).cloths.at(0);
}

/// One change to a valid scene, and the parts that the message must have.
struct BadScene {
  const char* pointer;  ///< JSON pointer of the value to set
  const char* value;    ///< JSON text; empty: the key is removed
  const char* path;     ///< JSON path in the message
  const char* text;     ///< what the message says, starting with the value
};

inline Json changed(Json scene, const BadScene& bad) {
  const Json::json_pointer pointer(bad.pointer);
  if (*bad.value)
    scene[pointer] = Json::parse(bad.value);
  else
    scene[pointer.parent_pointer()].erase(pointer.back());
  return scene;
}

inline void expect_refused(const Json& base, const std::vector<BadScene>& cases) {
  read_json(base);
  for (const BadScene& bad : cases) {
    SCOPED_TRACE(std::string(bad.pointer) + " = " + bad.value);
    const std::string message = input_error([&] { read_json(changed(base, bad)); });
    EXPECT_EQ(message.rfind("s.json: " + std::string(bad.path) + ": ", 0), 0u) << message;
    EXPECT_CONTAINS(message, bad.text);
  }
}

}  // namespace weft::io::test
