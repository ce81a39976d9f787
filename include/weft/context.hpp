// The entry point: a context owns the back end and makes fabrics and worlds.
#pragma once

#include "weft/world.hpp"

namespace weft {
inline namespace v0 {

enum class BackendKind : uint8_t { automatic, omp, cuda, hip };
/// x86-64 level of the host kernels. Every level gives the same bits.
enum class Isa : uint8_t { automatic, v2, v3, v4 };

struct ContextDesc {
  /// automatic: a GPU of this build if there is a usable one, else omp; the log says which and why.
  BackendKind backend = BackendKind::automatic;
  Isa isa = Isa::automatic;  ///< automatic: the highest that this processor has
  uint32_t threads = 0;      ///< 0: one per core; else honoured, also above the number of cores
  Allocator allocator;
  Log log;
  Jobs jobs;
  Profiler profiler;
};

struct ContextInfo {
  const char* backend;   ///< "omp", "cuda" or "hip"
  const char* device;    ///< name of the processor or GPU
  const char* isa;       ///< "v2", "v3", "v4"
  uint32_t threads;      ///< most threads a step uses
  const char* fallback;  ///< why a GPU of this build is not used; null when that did not happen
};

/// Safe to use from several threads. Outlived by nothing that it made.
class WEFT_API Context {
 public:
  Context() noexcept = default;
  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;
  ~Context();

  /// no_device: a back end or level asked for by name is not available; the log says why.
  static Result<Context> create(const ContextDesc& = {}, uint32_t abi = WEFT_ABI) noexcept;

  /// Checks, orders and stores a surface. Slow; meant for loading. Errors: invalid_argument with a
  /// message that names the element.
  Result<Fabric> cook(const GridDesc&) noexcept;
  Result<Fabric> cook(const MeshDesc&) noexcept;
  Result<Fabric> cook(const NetworkDesc&) noexcept;
  Result<ColliderMesh> cook(const ColliderMeshDesc&) noexcept;
  Result<World> create_world(const WorldDesc& = {}) noexcept;

  ContextInfo info() const noexcept;
  uint64_t bytes_allocated() const noexcept;  ///< held now for all it made, host and device

  struct Impl;
  explicit Context(Impl* made) noexcept : impl_(made) {}

 private:
  Impl* impl_ = nullptr;
};

/// "0.1.0 omp g++ 12.2.0"
WEFT_API const char* build_info() noexcept;

}  // namespace v0
}  // namespace weft
