#include "io/message_log.h"

namespace weft::io {

/// The library names its call first, "create_cloth, cloth 3: "; a user of scenes made no call.
static std::string without_call(const std::string& text) {
  const size_t colon = text.find(": ");
  const bool is_call = colon != std::string::npos && colon > 0 &&
                       text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789, ") >= colon;
  return is_call ? text.substr(colon + 2) : text;
}

std::string MessageLog::last_error(Status status) const {
  for (auto message = messages_.rbegin(); message != messages_.rend(); ++message) {
    if (message->severity == Severity::error) return without_call(message->text);
  }
  return to_string(status);
}

void MessageLog::receive(void* user, Severity severity, const char* text) {
  // A library that cannot allocate must not be thrown at.
  try {
    static_cast<MessageLog*>(user)->messages_.push_back({severity, text ? text : ""});
  } catch (const std::bad_alloc&) {
  }
}

}  // namespace weft::io
