// The whole content of a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace weft::io {

/// Bytes of a file, not initialised before they are read.
class FileText {
 public:
  FileText(std::unique_ptr<char[]> bytes, size_t size) : bytes_(std::move(bytes)), size_(size) {}
  std::string_view view() const { return {bytes_.get(), size_}; }
  char* begin() { return bytes_.get(); }
  char* end() { return bytes_.get() + size_; }

 private:
  std::unique_ptr<char[]> bytes_;
  size_t size_;
};

/// Bytes that this machine has.
uint64_t memory_size();
/// Bytes. The file of a mesh or point cache may take a quarter of this machine's memory, and what
/// is made of it, another quarter. A JSON document with the scene it becomes takes up to 45 times
/// its text: at most 256 MiB, and a sixty-fourth of the memory.
uint64_t largest_mesh_file();
uint64_t largest_scene_file();

/// Reads `path` in one go. InputError when it is missing, not a regular file, has more than
/// `largest` bytes (looked at before memory is taken), or cannot be read. An empty file is not an
/// error here.
FileText read_file(const std::string& path, uint64_t largest);

}  // namespace weft::io
