#include "api/context/teller.h"

namespace weft::api {

constexpr uint64_t always_told = 8;

uint64_t Teller::count_of(const Text& message) noexcept {
  uint64_t hash = 0xcbf29ce484222325ull;
  for (const char* c = message.c_str(); *c; ++c) {
    hash = (hash ^ static_cast<unsigned char>(*c)) * 0x100000001b3ull;
  }
  const std::lock_guard lock(mutex_);
  Said* of = &said_[0];
  for (Said& said : said_) {
    if (said.count > 0 && said.hash == hash) {
      of = &said;
      break;
    }
    if (said.when < of->when) of = &said;
  }
  if (of->hash != hash) *of = {hash, 0, 0};
  of->when = ++now_;
  return ++of->count;
}

void Teller::tell(const Log& log, Severity severity, const Text& message) noexcept {
  const uint64_t count = count_of(message);
  if (count <= always_told) return log.message(log.user, severity, message.c_str());
  if ((count & (count - 1)) != 0) return;
  const Text again =
      text("%s [said %llu times]", message.c_str(), static_cast<unsigned long long>(count));
  log.message(log.user, severity, again.c_str());
}

}  // namespace weft::api
