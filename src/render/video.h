// Films: pictures go to the ffmpeg program through a pipe.
#pragma once

#include "render/image.h"

#include "io/temporary_file.h"

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <string>

namespace weft::render {

/// An H.264 film in an MP4 file, which appears whole or not at all. UnavailableError where there is
/// no ffmpeg; OutputError when it fails, as far as the program ignores SIGPIPE.
class Video {
 public:
  Video(const std::string& path, uint32_t width, uint32_t height, double frames_per_second);
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;
  ~Video();

  void add(const Image&);
  void commit();

 private:
  [[noreturn]] void fail(const std::string& why);
  std::string complaint() const;  ///< the first line of what ffmpeg said
  int wait();                     ///< closes the pipe; ffmpeg's exit status
  void discard() noexcept;

  std::string path_;
  io::TemporaryFile temporary_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> complaints_;  ///< ffmpeg's standard error
  pid_t encoder_ = -1;
  int pipe_ = -1;
};

}  // namespace weft::render
