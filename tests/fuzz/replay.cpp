// Gives every file of some folders to a fuzz target, where the compiler has no libFuzzer.
// usage: PROGRAM FOLDER...
#include "fuzz.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv) {
  size_t count = 0;
  for (int folder = 1; folder < argc; ++folder) {
    size_t here = 0;
    for (const auto& entry : std::filesystem::directory_iterator(argv[folder])) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
      LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
      ++here;
    }
    if (here == 0) return 1;
    count += here;
  }
  std::printf("%zu files\n", count);
  return count > 0 ? 0 : 1;
}
