#include "io/message_log.h"

namespace weft::io {

std::string MessageLog::last_error(Status status) const {
  for (auto message = messages_.rbegin(); message != messages_.rend(); ++message) {
    if (message->severity == Severity::error) return message->text;
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
