#include <thread>

#include "api/context/context_state.h"
#include "api/world/state.h"
#include "scene/check.h"

namespace weft {
inline namespace v0 {

using api::ContextState;

Context::Context(Context&& other) noexcept : impl_(other.impl_) { other.impl_ = nullptr; }
Context& Context::operator=(Context&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}
Context::~Context() {
  if (!impl_) return;
  const std::shared_ptr<ContextState> keep = impl_->state;  // its memory
  delete impl_;
}

Result<Context> Context::create(const ContextDesc& desc, uint32_t abi) noexcept {
  const auto refuse = [&](Status status, const Text& message) {
    if (desc.log.message) desc.log.message(desc.log.user, Severity::error, message.c_str());
    return status;
  };
  try {
    if (abi != WEFT_ABI) {
      return refuse(
          Status::version_mismatch,
          text("the caller was built against ABI %u (this library has %u) build both from "
               "the same headers",
               abi, uint32_t(WEFT_ABI)));
    }
    if ((desc.allocator.allocate == nullptr) != (desc.allocator.deallocate == nullptr)) {
      return refuse(
          Status::invalid_argument,
          "allocator has one function of two (memory could not be given back) give both or "
          "neither");
    }
    if ((desc.jobs.workers == 0) != (desc.jobs.parallel_for == nullptr) ||
        (desc.jobs.launch && !desc.jobs.parallel_for)) {
      return refuse(Status::invalid_argument,
                    "jobs needs both workers and parallel_for (launch is an extra) give both or "
                    "neither");
    }
    if ((desc.profiler.zone_begin == nullptr) != (desc.profiler.zone_end == nullptr)) {
      return refuse(Status::invalid_argument,
                    "profiler has one function of two (a zone has two ends) give both or neither");
    }
    if (desc.jobs.workers > 1024) {
      return refuse(
          Status::invalid_argument,
          text("jobs.workers is %u (at most 1024) give a smaller number", desc.jobs.workers));
    }
    scene::check_choice(int(desc.backend), 4, "backend", "automatic, omp, cuda, hip");
    scene::check_choice(int(desc.isa), 4, "isa", "automatic, v2, v3, v4");
    if (desc.threads > 1024) {
      return refuse(Status::invalid_argument,
                    text("threads is %u (at most 1024) give a smaller number", desc.threads));
    }
    auto state = std::allocate_shared<ContextState>(
        api::UncountedAllocator<ContextState>(desc.allocator), desc);
    const MemoryScope scope(&state->memory);
    api::BackendChoice choice = api::choose_backend(desc.backend, desc.isa);
    if (!choice.backend) return refuse(Status::no_device, choice.refusal);
    state->backend = choice.backend;
    if (!choice.backend->info().host_memory) {
      state->host_backend = api::choose_backend(BackendKind::omp, Isa::automatic).backend;
      if (!state->host_backend) {
        return refuse(Status::no_device,
                      "no host back end fits this processor (outputs need one) build weft for it");
      }
    }
    state->fallback = choice.fallback;
    state->threads = desc.jobs.parallel_for ? desc.jobs.workers
                     : desc.threads > 0     ? desc.threads
                                            : std::max(1u, std::thread::hardware_concurrency());
    if (!choice.fallback.empty()) state->say(Severity::info, choice.fallback);
    const MemoryScope of_context(&state->uncounted);
    return Context(new Impl(state));
  } catch (const InvalidInput& problem) {
    return refuse(Status::invalid_argument, problem.what());
  } catch (const std::bad_alloc&) {
    return refuse(Status::out_of_memory, "out of memory (a context could not be made) free some");
  }
}

/// Cooks a Fabric or a ColliderMesh.
template <class Cooked, class Desc, class Cook>
static Result<Cooked> cook_with(const Context::Impl* impl, const Desc& desc, Cook cook) noexcept {
  if (!impl) return Status::invalid_handle;
  const api::Zone zone(*impl->state, "weft cook");
  const api::AskScope asked("cook");
  typename Cooked::Impl* made = nullptr;
  const Status status = api::guarded(*impl->state, [&] {
    auto cooking = std::make_unique<typename Cooked::Impl>(impl->state);
    cook(desc, cooking->cooked);
    for (const scene::CookedDiagnostic& d : cooking->cooked.diagnostics) {
      cooking->diagnostics.push_back({d.severity, d.element, d.text.c_str()});
    }
    made = cooking.release();
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return Cooked(made);
}

Result<Fabric> Context::cook(const GridDesc& desc) noexcept {
  return cook_with<Fabric>(impl_, desc, scene::cook_grid);
}
Result<Fabric> Context::cook(const MeshDesc& desc) noexcept {
  return cook_with<Fabric>(impl_, desc, scene::cook_mesh);
}
Result<Fabric> Context::cook(const NetworkDesc& desc) noexcept {
  return cook_with<Fabric>(impl_, desc, scene::cook_network);
}
Result<ColliderMesh> Context::cook(const ColliderMeshDesc& desc) noexcept {
  return cook_with<ColliderMesh>(impl_, desc, scene::cook_collider_mesh);
}

Result<World> Context::create_world(const WorldDesc& desc) noexcept {
  if (!impl_) return Status::invalid_handle;
  const api::AskScope asked("create_world");
  World::Impl* made = nullptr;
  const Status status = api::guarded(*impl_->state, [&] {
    api::check_world(desc);
    made = new World::Impl(impl_->state, desc);
    return Status::ok;
  });
  if (status != Status::ok) return status;
  return World(made);
}

ContextInfo Context::info() const noexcept {
  if (!impl_) return {"", "", "", 0, nullptr};
  const ContextState& s = *impl_->state;
  const BackendInfo& b = s.backend->info();
  return {b.name, b.device, b.isa, s.threads, s.fallback.empty() ? nullptr : s.fallback.c_str()};
}

uint64_t Context::bytes_allocated() const noexcept {
  return impl_ ? impl_->state->memory.held() : 0;
}

}  // namespace v0
}  // namespace weft
