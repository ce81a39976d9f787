// What a context holds. Fabrics and worlds share it, so the order of destruction is free.
#pragma once

#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>

#include "api/context/memory.h"
#include "api/context/registry.h"
#include "api/context/teller.h"
#include "base/host_memory.h"
#include "base/message_host.h"
#include "scene/collider_mesh.h"
#include "scene/fabric.h"

namespace weft {
namespace api {

/// The call that this thread has made, for messages.
struct Asked {
  const char* call = nullptr;
  ClothId cloth;  ///< that it is about; null: none, or all
};
inline thread_local Asked asked_of_thread;

/// As long as it lives, this thread has made the call.
class AskScope {
 public:
  explicit AskScope(const char* call) noexcept : before_(asked_of_thread) {
    asked_of_thread = {call, {}};
  }
  ~AskScope() { asked_of_thread = before_; }
  AskScope(const AskScope&) = delete;
  AskScope& operator=(const AskScope&) = delete;

 private:
  Asked before_;
};

struct ContextState {
  explicit ContextState(const ContextDesc& desc)
      : uncounted(desc.allocator),
        memory(desc.allocator),
        log(desc.log),
        jobs(desc.jobs),
        profiler(desc.profiler) {}

  Workers workers() const noexcept {
    return {static_cast<int>(threads), jobs.parallel_for ? &jobs : nullptr};
  }
  /// The back end that can write to the host's memory.
  const Backend& host() const noexcept { return host_backend ? *host_backend : *backend; }

  /// Takes no memory.
  void say(Severity severity, const Text& message) noexcept {
    if (log.message) teller.tell(log, severity, message);
  }
  /// Says which call, about which cloth, has failed.
  Status fail(Status status, const Text& message) noexcept {
    const Asked& asked = asked_of_thread;
    if (!asked.call) {
      say(Severity::error, message);
    } else if (!asked.cloth) {
      say(Severity::error, text("%s: %s", asked.call, message.c_str()));
    } else {
      say(Severity::error,
          text("%s, cloth %u: %s", asked.call, asked.cloth.index, message.c_str()));
    }
    return status;
  }

  UncountedMemory uncounted;  ///< for Context::Impl, which does not count
  ContextMemory memory;
  Log log;
  Jobs jobs;
  Profiler profiler;
  const Backend* backend = nullptr;
  const Backend* host_backend = nullptr;  ///< null: `backend` is the host's
  uint32_t threads = 1;
  Text fallback;
  Teller teller;
};

/// A zone of the caller's profiler, as long as it lives.
class Zone {
 public:
  Zone(const ContextState& context, const char* name) noexcept : profiler_(context.profiler) {
    if (profiler_.zone_begin) zone_ = profiler_.zone_begin(profiler_.user, name);
  }
  ~Zone() {
    if (profiler_.zone_end) profiler_.zone_end(profiler_.user, zone_);
  }
  Zone(const Zone&) = delete;
  Zone& operator=(const Zone&) = delete;

 private:
  const Profiler& profiler_;
  void* zone_ = nullptr;
};

/// Runs `body`, which returns a Status and takes its memory from the context, and turns what it
/// throws into a Status.
template <class Body>
Status guarded(ContextState& context, const Body& body) noexcept {
  const MemoryScope scope(&context.memory);
  try {
    return body();
  } catch (const InvalidInput& problem) {
    return context.fail(Status::invalid_argument, problem.what());
  } catch (const std::length_error&) {
    return context.fail(Status::out_of_memory,
                        "out of memory (there is not that much) make the scene smaller");
  } catch (const std::bad_alloc&) {
    return context.fail(
        Status::out_of_memory,
        "out of memory (the allocator gave none) free some or make the scene smaller");
  }
}

}  // namespace api

inline namespace v0 {
struct Context::Impl : HostObject {
  explicit Impl(std::shared_ptr<api::ContextState> made) : state(std::move(made)) {}

  std::shared_ptr<api::ContextState> state;
};

struct Fabric::Impl : HostObject {
  explicit Impl(std::shared_ptr<api::ContextState> owner)
      : context(std::move(owner)), cooked(&context->memory) {}

  std::shared_ptr<api::ContextState> context;
  std::atomic<uint32_t> references{1};
  scene::CookedFabric cooked;
  std::pmr::vector<Diagnostic> diagnostics{&context->memory};
};

struct ColliderMesh::Impl : HostObject {
  explicit Impl(std::shared_ptr<api::ContextState> owner)
      : context(std::move(owner)), cooked(&context->memory) {}

  std::shared_ptr<api::ContextState> context;
  std::atomic<uint32_t> references{1};
  scene::CookedColliderMesh cooked;
  std::pmr::vector<Diagnostic> diagnostics{&context->memory};
};
}  // namespace v0
}  // namespace weft
