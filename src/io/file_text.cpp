#include "io/file_text.h"

#include "io/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace weft::io {
namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      // Without O_NONBLOCK opening a pipe that nobody writes to would wait for ever.
      : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail_open(const std::string& path) {
  throw InputError(path + ": cannot be read (" + std::strerror(errno) +
                   ") give the path of an existing file");
}

uint64_t checked_size(const std::string& path, int descriptor, uint64_t largest) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) fail_open(path);
  if (S_ISDIR(status.st_mode)) {
    throw InputError(path + ": is a directory (a file is needed) give the path of a file");
  }
  if (!S_ISREG(status.st_mode)) {
    throw InputError(path + ": is not a regular file (its size must be known) give a file on disk");
  }
  const auto size = uint64_t(status.st_size);
  if (size > largest) {
    throw InputError(path + ": has " + std::to_string(size) + " bytes (at most " +
                     std::to_string(largest) + " are read on this machine) give a smaller file");
  }
  return size;
}

}  // namespace

uint64_t memory_size() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return uint64_t(1) << 34;
  return uint64_t(pages) * uint64_t(page);
}

uint64_t largest_mesh_file() { return memory_size() / 4; }
uint64_t largest_scene_file() { return std::min(memory_size() / 64, uint64_t(1) << 28); }

FileText read_file(const std::string& path, uint64_t largest) {
  const Descriptor file(path);
  if (file.number() < 0) fail_open(path);
  const uint64_t size = checked_size(path, file.number(), largest);
  auto bytes = std::make_unique_for_overwrite<char[]>(size_t(size) + 1);
  size_t done = 0;
  while (done < size) {
    const size_t chunk = std::min<size_t>(size_t(size) - done, size_t(1) << 30);
    const ssize_t got = ::read(file.number(), bytes.get() + done, chunk);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_open(path);
    if (got == 0) break;
    done += size_t(got);
  }
  bytes[done] = '\0';
  return {std::move(bytes), done};
}

}  // namespace weft::io
