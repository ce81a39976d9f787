// Writes a scene with each row of the table of effects, and a dictionary with the rows' words.
// usage: PROGRAM FOLDER DICTIONARY   reads a dictionary, writes FOLDER/scene.dict and
//                                    FOLDER/scene/NAME.json
#include "samples/effects/effects.h"
#include "samples/effects/scene_text.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Everything between two quotes.
void append_words(const std::string& text, std::set<std::string>& words) {
  for (size_t open = text.find('"'); open != text.npos;) {
    const size_t close = text.find('"', open + 1);
    if (close == text.npos) return;
    words.insert("\"\\\"" + text.substr(open + 1, close - open - 1) + "\\\"\"\n");
    open = text.find('"', close + 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder / "scene");
  std::set<std::string> words;
  size_t count = 0;
  for (const weft::samples::Effect& effect : weft::samples::effects) {
    if (!effect.has_keys()) continue;
    const std::string scene = weft::samples::scene_text(effect);
    append_words(scene, words);
    std::ofstream(folder / "scene" / (std::string(effect.name) + ".json")) << scene;
    ++count;
  }
  std::string dictionary = text_of(argv[2]);
  if (dictionary.empty()) return 1;
  for (const std::string& word : words) {
    if (dictionary.find(word) == dictionary.npos) dictionary += word;
  }
  std::ofstream(folder / "scene.dict") << dictionary;
  std::printf("%zu scenes\n", count);
  return count > 0 ? 0 : 1;
}
