// What a context holds. Fabrics and worlds share it, so the order of destruction is free.
#pragma once

#include <memory>
#include <mutex>
#include <new>
#include <string>

#include "api/context/memory.h"
#include "api/context/registry.h"
#include "base/message_host.h"
#include "scene/collider_mesh.h"
#include "scene/fabric.h"

namespace weft {
namespace api {

struct ContextState {
  explicit ContextState(const ContextDesc& desc)
      : memory(desc.allocator), log(desc.log), jobs(desc.jobs), profiler(desc.profiler) {}

  Workers workers() const noexcept {
    return {static_cast<int>(threads), jobs.parallel_for ? &jobs : nullptr};
  }
  /// The back end that can write to the host's memory.
  const Backend& host() const noexcept { return host_backend ? *host_backend : *backend; }

  void say(Severity severity, const std::string& message) noexcept {
    if (log.message) log.message(log.user, severity, message.c_str());
  }
  Status fail(Status status, const std::string& message) noexcept {
    say(Severity::error, message);
    return status;
  }

  ContextMemory memory;
  Log log;
  Jobs jobs;
  Profiler profiler;
  const Backend* backend = nullptr;
  const Backend* host_backend = nullptr;  ///< null: `backend` is the host's
  uint32_t threads = 1;
  std::string fallback;
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

/// Runs `body`, which returns a Status, and turns what it throws into one.
template <class Body>
Status guarded(ContextState& context, const Body& body) noexcept {
  try {
    return body();
  } catch (const InvalidInput& problem) {
    return context.fail(Status::invalid_argument, problem.what());
  } catch (const std::bad_alloc&) {
    return context.fail(
        Status::out_of_memory,
        "out of memory (the allocator gave none) free some or make the scene smaller");
  }
}

}  // namespace api

inline namespace v0 {
struct Context::Impl {
  std::shared_ptr<api::ContextState> state;
};

struct Fabric::Impl {
  explicit Impl(std::shared_ptr<api::ContextState> owner)
      : context(std::move(owner)), cooked(&context->memory) {}

  std::shared_ptr<api::ContextState> context;
  std::atomic<uint32_t> references{1};
  scene::CookedFabric cooked;
  std::pmr::vector<Diagnostic> diagnostics{&context->memory};
};

struct ColliderMesh::Impl {
  explicit Impl(std::shared_ptr<api::ContextState> owner)
      : context(std::move(owner)), cooked(&context->memory) {}

  std::shared_ptr<api::ContextState> context;
  std::atomic<uint32_t> references{1};
  scene::CookedColliderMesh cooked;
  std::pmr::vector<Diagnostic> diagnostics{&context->memory};
};
}  // namespace v0
}  // namespace weft
