#include "io/output_file.h"

#include "io/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace weft::io {
namespace {

namespace fs = std::filesystem;
constexpr size_t buffer_size = size_t(1) << 18;

bool is_device(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

}  // namespace

OutputFile::OutputFile(const std::string& path, Sync sync) : path_(path), sync_(sync) {
  buffer_.reserve(buffer_size);
  if (is_device(path)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("opened");
    return;
  }
  target_ = follow_links(path);
  std::error_code ignored;
  if (path.empty() || fs::is_directory(target_, ignored)) {
    errno = path.empty() ? ENOENT : EISDIR;
    fail("opened");
  }
  if (fs::is_symlink(target_, ignored)) {
    errno = ELOOP;
    fail("opened");
  }
  // Its temporary neighbour may have a name that is short enough.
  struct stat status {};
  if (::lstat(target_.c_str(), &status) != 0 && errno != ENOENT) fail("opened");
  temporary_ = TemporaryFile(target_);
  descriptor_ = ::open(temporary_.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("made");
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::write(std::string_view bytes) {
  if (buffer_.size() + bytes.size() > buffer_size) flush();
  if (bytes.size() < buffer_size) {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return;
  }
  write_through(bytes);
}

void OutputFile::flush() {
  write_through({buffer_.data(), buffer_.size()});
  buffer_.clear();
}

void OutputFile::write_through(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("written");
    bytes.remove_prefix(size_t(done));
  }
}

void OutputFile::overwrite(size_t offset, std::string_view bytes) {
  flush();
  while (!bytes.empty()) {
    const ssize_t done = ::pwrite(descriptor_, bytes.data(), bytes.size(), off_t(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("written");
    bytes.remove_prefix(size_t(done));
    offset += size_t(done);
  }
}

void OutputFile::commit() {
  flush();
  if (sync_ == Sync::yes && !temporary_.path().empty() && ::fsync(descriptor_) != 0)
    fail("written");
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail("closed");
  if (!temporary_.path().empty() && !temporary_.become(target_)) fail("renamed");
}

void OutputFile::fail(const char* doing) {
  const int code = errno;
  discard();
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  throw OutputError(path_ + ": cannot be " + doing + " (" + std::strerror(code) + ") " +
                    (full ? "free space or " : "") + "give another path");
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  temporary_.remove();
}

std::string follow_links(const std::string& path) {
  fs::path at = path;
  for (int depth = 0; depth < 40; ++depth) {
    std::error_code none;
    const fs::path next = fs::read_symlink(at, none);
    if (none) break;
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at.string();
}

// Whoever reads from a pipe would take a trial for the end.
void probe_output(const std::string& path) {
  if (!is_device(path)) {
    const OutputFile file(path);
  } else if (::access(path.c_str(), W_OK) != 0) {
    throw OutputError(path + ": cannot be opened (" + std::strerror(errno) + ") give another path");
  }
}

void make_folder(const std::string& path) {
  std::error_code failure;
  fs::create_directories(path, failure);
  if (!failure && !fs::is_directory(path, failure))
    failure = std::make_error_code(std::errc::not_a_directory);
  std::error_code ignored;
  if (failure && fs::is_symlink(path, ignored) && !fs::exists(path, ignored)) {
    throw OutputError(
        path + ": is a link to nothing (a folder is needed) remove it, or give another path");
  }
  if (failure) {
    throw OutputError(path + ": the folder cannot be made (" + failure.message() +
                      ") give another path");
  }
}

}  // namespace weft::io
