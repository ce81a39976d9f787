#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace weft::tools {

Progress::Progress(uint64_t total) : total_(total), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::update(uint64_t done) {
  if (!terminal_ || total_ == 0) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  shown_ = true;
  constexpr size_t width = 30;
  const double part = std::min(1.0, double(done) / double(total_));
  const auto full = size_t(part * width);
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const double left = done > 0 ? seconds * double(total_ - done) / double(done) : 0;
  std::fprintf(stderr, "\r[%s%s] frame %llu of %llu, %.0f s left\033[K",
               std::string(full, '#').c_str(), std::string(width - full, '.').c_str(),
               static_cast<unsigned long long>(done), static_cast<unsigned long long>(total_),
               left);
  std::fflush(stderr);
}

}  // namespace weft::tools
