#include "render/video.h"

#include "io/error.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <vector>

extern char** environ;

namespace weft::render {
namespace {

/// The descriptors that ffmpeg gets. It writes the film to one that is open already: no name of a
/// file looks like an option or a protocol then, and none comes to life again after we have gone.
struct Ends {
  int input, errors, film;
};
constexpr int film_descriptor = 3;
constexpr const char* film = "file:/dev/fd/3";

/// Raw pictures in, H.264 that every player knows out. Its picture has even sides, so an odd one is
/// padded.
std::vector<std::string> command(uint32_t width, uint32_t height, double rate) {
  std::stringstream line;
  line << "ffmpeg -nostdin -loglevel error -f rawvideo -pix_fmt rgb24 -video_size " << width << "x"
       << height << " -framerate " << std::setprecision(9) << rate << " -i pipe:0 "
       << "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2 -c:v libx264 -pix_fmt yuv420p -crf 20 "
       << "-movflags +faststart -f mp4 -y " << film;
  return {std::istream_iterator<std::string>(line), {}};
}

/// Starts ffmpeg; an error number.
int start(const std::vector<std::string>& words, const Ends& ends, pid_t& process) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends.input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends.errors, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends.film, film_descriptor);
  // In a group of its own: Ctrl-C stops weft, which then ends the film.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int code = ::posix_spawnp(&process, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return code;
}

}  // namespace

Video::Video(const std::string& path, uint32_t width, uint32_t height, double frames_per_second)
    : path_(path), temporary_(path), complaints_(std::tmpfile(), std::fclose) {
  if (!complaints_) fail(std::strerror(errno));
  const int file = ::open(temporary_.path().c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) fail(std::strerror(errno));
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    ::close(file);
    fail(std::strerror(errno));
  }
  pipe_ = ends[1];
  const int code = start(command(width, height, frames_per_second),
                         {ends[0], ::fileno(complaints_.get()), file}, encoder_);
  ::close(ends[0]);
  ::close(file);
  if (code == 0) return;
  encoder_ = -1;
  discard();
  throw io::UnavailableError(path_ + ": films cannot be made (ffmpeg: " + std::strerror(code) +
                             ") install it, for example apt-get install ffmpeg, or write png");
}

Video::~Video() { discard(); }

void Video::add(const Image& image) {
  const uint8_t* at = image.rgb.data();
  size_t left = image.rgb.size();
  while (left > 0) {
    const ssize_t done = ::write(pipe_, at, left);
    if (done >= 0) {
      at += done;
      left -= size_t(done);
    } else if (errno != EINTR) {
      const std::string why = std::strerror(errno);
      wait();
      fail("ffmpeg takes no more pictures: " + why + complaint());
    }
  }
}

// A full disk at the end of a film is no error to ffmpeg, but it complains.
void Video::commit() {
  const int status = wait();
  const std::string said = complaint();
  if (status != 0) fail("ffmpeg ended with status " + std::to_string(status) + said);
  if (!said.empty()) fail("ffmpeg" + said);
  if (!temporary_.become(path_)) fail(std::strerror(errno));
}

std::string Video::complaint() const {
  char line[200] = "";
  std::rewind(complaints_.get());
  if (!std::fgets(line, sizeof line, complaints_.get())) return "";
  return ": " + std::string(line, std::strcspn(line, "\n"));
}

int Video::wait() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
  if (encoder_ < 0) return 0;
  int status = 0;
  while (::waitpid(encoder_, &status, 0) < 0 && errno == EINTR) {
  }
  encoder_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void Video::fail(const std::string& why) {
  discard();
  throw io::OutputError(path_ + ": cannot be written (" + why +
                        ") free space, give another path, or write png");
}

void Video::discard() noexcept {
  if (encoder_ >= 0) ::kill(encoder_, SIGTERM);
  wait();
  temporary_.remove();
}

}  // namespace weft::render
