// Files that are not whole yet.
#pragma once

#include <string>

namespace weft::io {

/// A name beside `target` for what will become it. The file is removed unless it does.
class TemporaryFile {
 public:
  TemporaryFile() = default;
  explicit TemporaryFile(const std::string& target);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) noexcept;
  ~TemporaryFile() { remove(); }

  /// Empty: there is none.
  const std::string& path() const { return path_; }
  /// False, with the reason in errno, when it cannot be renamed.
  bool become(const std::string& target);
  void remove() noexcept;

  /// Those of all objects: for a program that ends at once. From any thread.
  static void remove_all() noexcept;

 private:
  void forget() noexcept;

  std::string path_;
};

}  // namespace weft::io
