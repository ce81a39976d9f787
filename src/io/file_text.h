// The whole content of a file.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace weft::io {

/// Bytes of a file, not initialised before they are read.
class FileText {
 public:
  FileText(std::unique_ptr<char[]> bytes, size_t size) : bytes_(std::move(bytes)), size_(size) {}
  std::string_view view() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<char[]> bytes_;
  size_t size_;
};

/// Reads `path` in one go. InputError when it is missing, not a regular file, larger than a quarter
/// of the memory of this machine, or cannot be read. An empty file is not an error here.
FileText read_file(const std::string& path);

}  // namespace weft::io
