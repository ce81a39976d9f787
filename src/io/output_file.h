// Files that appear whole or not at all.
#pragma once

#include "io/temporary_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace weft::io {

/// What commit() waits for. A frame of many need not survive a power cut; a result should.
enum class Sync : bool { no, yes };

/// Collects bytes under a temporary name in the folder of `path`; commit() renames it. Without a
/// commit, or after a failure, nothing is left. A device or pipe (/dev/stdout) is written directly,
/// because renaming would replace it. Every call throws OutputError on failure.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path, Sync sync = Sync::no);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view bytes);
  void write(const void* bytes, size_t count) {
    write(std::string_view(static_cast<const char*>(bytes), count));
  }
  /// Replaces bytes that were written before. Not of a device or a pipe.
  void overwrite(size_t offset, std::string_view bytes);
  void commit();

 private:
  [[noreturn]] void fail(const char* doing);
  void flush();
  void write_through(std::string_view bytes);
  void discard() noexcept;

  std::string path_;         ///< as given, for messages
  std::string target_;       ///< with symbolic links followed
  TemporaryFile temporary_;  ///< none: written directly
  Sync sync_;
  int descriptor_ = -1;
  std::vector<char> buffer_;
};

/// The file that a chain of symbolic links ends at, also when it does not exist yet.
std::string follow_links(const std::string& path);
/// Throws OutputError when a file at `path` could not be made. Leaves nothing behind.
void probe_output(const std::string& path);
/// Makes the folder and its parents.
void make_folder(const std::string& path);

}  // namespace weft::io
