#include "api/context/teller.h"

namespace weft::api {

namespace {

constexpr uint64_t always_told = 8, always_told_forms = 128;

bool is_due(uint64_t count, uint64_t always) {
  return count <= always || (count & (count - 1)) == 0;
}

uint64_t hash_of(const Text& message, bool numbers) {
  uint64_t hash = 0xcbf29ce484222325ull;
  for (const char* c = message.c_str(); *c; ++c) {
    const bool of_number = (*c >= '0' && *c <= '9') || *c == '.' || *c == '-' || *c == '+';
    if (of_number && !numbers) continue;
    hash = (hash ^ static_cast<unsigned char>(*c)) * 0x100000001b3ull;
  }
  return hash;
}

}  // namespace

uint64_t Teller::Memory::count(uint64_t hash) noexcept {
  Said* of = &said[0];
  for (Said& one : said) {
    if (one.count > 0 && one.hash == hash) {
      of = &one;
      break;
    }
    if (one.when < of->when) of = &one;
  }
  if (of->hash != hash) *of = {hash, 0, 0};
  of->when = ++now;
  return ++of->count;
}

void Teller::tell(const Log& log, Severity severity, const Text& message) noexcept {
  uint64_t count = 0, alike = 0;
  {
    const std::lock_guard lock(mutex_);
    count = texts_.count(hash_of(message, true));
    if (!is_due(count, always_told)) return;
    alike = forms_.count(hash_of(message, false));
  }
  if (!is_due(alike, always_told_forms)) return;
  if (count <= always_told) return log.message(log.user, severity, message.c_str());
  const Text again =
      text("%s [said %llu times]", message.c_str(), static_cast<unsigned long long>(count));
  log.message(log.user, severity, again.c_str());
}

}  // namespace weft::api
