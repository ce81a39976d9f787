#include "arguments.h"

#include "io/error.h"
#include "io/scene.h"
#include "io/text_cursor.h"

#include <algorithm>

namespace weft::tools {
namespace {

template <class Value>
Value choose(const std::string& option, const std::string& text,
             std::initializer_list<std::pair<const char*, Value>> choices) {
  std::string allowed;
  for (const auto& [name, value] : choices) {
    if (text == name) return value;
    allowed += (allowed.empty() ? "" : ", ") + std::string(name);
  }
  bad_argument(option, text, "is not one of the choices", "give one of " + allowed);
}

uint32_t thread_count(const std::string& text) {
  int64_t threads = 0;
  io::Cursor cursor(text);
  const bool whole = io::next_integer(cursor, threads) == io::NumberFault::none;
  if (!whole || !io::at_end(cursor) || threads < 1 || threads > 1024) {
    bad_argument("--threads", text, "is out of range", "give an integer from 1 to 1024");
  }
  return uint32_t(threads);
}

FrameFormat frame_format(const std::string& name) {
  return choose<FrameFormat>("--format", name,
                             {{"obj", FrameFormat::obj},
                              {"ply", FrameFormat::ply},
                              {"pc2", FrameFormat::pc2},
                              {"png", FrameFormat::png},
                              {"mp4", FrameFormat::mp4}});
}

}  // namespace

void bad_argument(const std::string& option, const std::string& value, const std::string& why,
                  const std::string& remedy) {
  throw io::InputError(option + ": " + io::quoted(value) + " " + why + " (run 'weft --help') " +
                       remedy);
}

double seconds_argument(const std::string& option, const std::string& text, bool positive) {
  double value = 0;
  io::Cursor cursor(text);
  const bool number = io::next_real(cursor, value) == io::NumberFault::none && io::at_end(cursor);
  if (!number) bad_argument(option, text, "is not a finite number", "give seconds");
  if (value < 0 || (positive && value == 0)) {
    bad_argument(option, text, "is out of range",
                 positive ? "give seconds above 0" : "give seconds >= 0");
  }
  return value;
}

PictureSize size_argument(const std::string& option, const std::string& text) {
  const auto side = [&](const std::string& word) {
    int64_t pixels = 0;
    io::Cursor cursor(word);
    const bool whole = io::next_integer(cursor, pixels) == io::NumberFault::none;
    if (!whole || !io::at_end(cursor) || pixels < io::least_pixels || pixels > io::most_pixels) {
      bad_argument(option, text, "is not a size of pictures",
                   "give WIDTHxHEIGHT, each from " + std::to_string(io::least_pixels) + " to " +
                       std::to_string(io::most_pixels));
    }
    return uint32_t(pixels);
  };
  const size_t cross = std::min(text.find('x'), text.size());
  return {side(text.substr(0, cross)), side(text.substr(std::min(cross + 1, text.size())))};
}

ContextDesc context_desc(const CommonOptions& options) {
  ContextDesc desc;
  desc.backend = choose<BackendKind>("--backend", options.backend,
                                     {{"auto", BackendKind::automatic},
                                      {"omp", BackendKind::omp},
                                      {"cuda", BackendKind::cuda},
                                      {"hip", BackendKind::hip}});
  desc.isa =
      choose<Isa>("--isa", options.isa,
                  {{"auto", Isa::automatic}, {"v2", Isa::v2}, {"v3", Isa::v3}, {"v4", Isa::v4}});
  if (!options.threads.empty()) desc.threads = thread_count(options.threads);
  return desc;
}

std::vector<FrameFormat> frame_formats(const std::string& list) {
  std::vector<FrameFormat> formats;
  size_t begin = 0;
  while (begin <= list.size()) {
    const size_t end = std::min(list.find(',', begin), list.size());
    const FrameFormat format = frame_format(list.substr(begin, end - begin));
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
      formats.push_back(format);
    }
    begin = end + 1;
  }
  return formats;
}

}  // namespace weft::tools
