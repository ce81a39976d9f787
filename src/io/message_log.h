// What the library said, kept for the one message a user sees.
#pragma once

#include "weft/core.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace weft::io {

struct Message {
  Severity severity;
  std::string text;
};

/// Stays where it is: a context holds its address.
class MessageLog {
 public:
  MessageLog() = default;
  MessageLog(const MessageLog&) = delete;
  MessageLog& operator=(const MessageLog&) = delete;

  Log callback() { return {this, &MessageLog::receive}; }
  const std::vector<Message>& messages() const { return messages_; }
  /// Text of the latest error without the name of its call, or the name of `status` when there was
  /// none.
  std::string last_error(Status status) const;

 private:
  static void receive(void* user, Severity severity, const char* text);
  std::vector<Message> messages_;
};

/// The library refused a call.
struct CoreError : std::runtime_error {
  CoreError(Status status_, const std::string& text) : std::runtime_error(text), status(status_) {}
  Status status;
};

}  // namespace weft::io
