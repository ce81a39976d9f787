#include "io/temporary_file.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>

namespace weft::io {
namespace {

struct Registry {
  std::mutex mutex;
  std::set<std::string> paths;
};

// Never destroyed: threads may still look at it when the program ends.
Registry& registry() {
  static Registry& only = *new Registry;
  return only;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& target) {
  static std::atomic<unsigned> serial{0};
  const std::filesystem::path path = target;
  constexpr size_t longest = 200;  // of the 255 bytes that a name may have
  const std::string name = "." + path.filename().string().substr(0, longest) + "." +
                           std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp";
  path_ = (path.parent_path() / name).string();
  const std::lock_guard<std::mutex> lock(registry().mutex);
  registry().paths.insert(path_);
}

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

bool TemporaryFile::become(const std::string& target) {
  if (::rename(path_.c_str(), target.c_str()) != 0) return false;
  forget();
  return true;
}

void TemporaryFile::remove() noexcept {
  if (path_.empty()) return;
  ::unlink(path_.c_str());
  forget();
}

void TemporaryFile::forget() noexcept {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  registry().paths.erase(path_);
  path_.clear();
}

void TemporaryFile::remove_all() noexcept {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  for (const std::string& path : registry().paths) ::unlink(path.c_str());
}

}  // namespace weft::io
