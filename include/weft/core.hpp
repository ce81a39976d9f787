// Basic types of the public interface: values, views, ids, status codes and host services.
//
// Nothing here needs exceptions, RTTI or a container, and no configuration macro changes a type.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(WEFT_STATIC)
#  define WEFT_API
#elif defined(__GNUC__)
#  define WEFT_API __attribute__((visibility("default")))
#elif defined(WEFT_BUILDING)
#  define WEFT_API __declspec(dllexport)
#else
#  define WEFT_API __declspec(dllimport)
#endif

#define WEFT_VERSION_MAJOR 0
#define WEFT_VERSION_MINOR 1
#define WEFT_VERSION_PATCH 0
/// Number of the binary layout of these headers: that of the inline namespace, of the shared
/// library's SONAME and of its package. Raised whenever a released struct changes.
#define WEFT_ABI 0

namespace weft {
inline namespace v0 {

struct float3 {
  float x, y, z;
};
struct double3 {
  double x, y, z;
};

/// Non-owning strided view of `count` elements, `stride` bytes apart. The elements must be aligned
/// for T. A view may point straight into an engine's interleaved buffer. It holds fewer than 2^32 -
/// 1 elements; one of more has that count, and every call refuses it.
template <class T>
struct View {
  const void* data = nullptr;
  uint32_t count = 0;
  uint32_t stride = sizeof(T);

  constexpr View() = default;
  constexpr View(const T* first, size_t n) : data(first), count(counted(n)) {}
  constexpr View(const void* first, size_t n, uint32_t byte_stride)
      : data(first), count(counted(n)), stride(byte_stride) {}
  /// From anything contiguous that has data() and size(): vector, array, span.
  template <class Container,
            class = decltype(static_cast<const T*>(static_cast<const Container*>(nullptr)->data()))>
  constexpr View(const Container& c) : data(c.data()), count(counted(c.size())) {}

  static constexpr uint32_t too_many = ~0u;
  static constexpr uint32_t counted(size_t n) {
    return n < too_many ? static_cast<uint32_t>(n) : too_many;
  }

  constexpr bool empty() const { return count == 0; }
  /// Element i. Not checked: i must be below `count`.
  const T& operator[](uint32_t i) const {
    return *reinterpret_cast<const T*>(static_cast<const char*>(data) + size_t(i) * stride);
  }
};

/// Points in metres, float or double, any stride: what engines and tools have.
struct PointView {
  const void* data = nullptr;
  uint32_t count = 0;
  uint32_t stride = 0;
  bool is_double = false;

  constexpr PointView() = default;
  constexpr PointView(View<float3> v) : data(v.data), count(v.count), stride(v.stride) {}
  constexpr PointView(View<double3> v)
      : data(v.data), count(v.count), stride(v.stride), is_double(true) {}

  constexpr bool empty() const { return count == 0; }
  double3 operator[](uint32_t i) const {
    const char* p = static_cast<const char*>(data) + size_t(i) * stride;
    if (is_double) return *reinterpret_cast<const double3*>(p);
    const float3 f = *reinterpret_cast<const float3*>(p);
    return {double(f.x), double(f.y), double(f.z)};
  }
};

/// Outcome of every call that can fail. The text that goes with a failure is sent to Log.
enum class Status : int32_t {
  ok = 0,
  invalid_argument,  ///< a value is out of range; the message names it
  invalid_handle,    ///< null, stale or foreign id
  version_mismatch,  ///< the headers and the library have different ABI numbers
  out_of_memory,
  no_device,      ///< the back end asked for is not in this build or has no usable device
  device_lost,    ///< the device reported an error; the world cannot go on
  unsupported,    ///< valid, but not available in this version
  unstable_step,  ///< the step is beyond the stable bound and `unsafe` is off
  diverged,       ///< a position is no longer finite
  wrong_thread,   ///< another thread is inside the same world
  in_flight,      ///< a step has begun and has not ended
};
WEFT_API const char* to_string(Status) noexcept;

/// A value or the reason why there is none. Reading the value of a failed result gives T{}.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) noexcept : value_(static_cast<T&&>(value)), status_(Status::ok) {}
  Result(Status failure) noexcept : value_{}, status_(failure) {}

  explicit operator bool() const noexcept { return status_ == Status::ok; }
  Status status() const noexcept { return status_; }
  T& operator*() noexcept { return value_; }
  const T& operator*() const noexcept { return value_; }
  T* operator->() noexcept { return &value_; }
  const T* operator->() const noexcept { return &value_; }

 private:
  T value_;
  Status status_;
};

/// Names an object by slot and generation. A process gives an id once, in whatever world, to
/// whatever kind of object: that of a destroyed object, or of another world, names nothing.
/// Trivially copyable; a value-initialised id is null.
template <class Tag>
struct Id {
  uint32_t index = 0;
  uint32_t generation = 0;
  explicit constexpr operator bool() const { return generation != 0; }
  friend constexpr bool operator==(Id a, Id b) {
    return a.index == b.index && a.generation == b.generation;
  }
  friend constexpr bool operator!=(Id a, Id b) { return !(a == b); }
};
using ClothId = Id<struct cloth_tag>;
using ColliderId = Id<struct collider_tag>;
using ColliderSetId = Id<struct collider_set_tag>;
using OutputId = Id<struct output_tag>;

enum class Severity : uint8_t { info, warning, error };

/// Memory of a context. Both functions or neither; null means the C++ heap. All host memory of weft
/// passes through it, but for what others take: the thread of begin_step, OpenMP, a GPU's runtime,
/// exceptions of the C++ library. Called from the thread that calls weft. `allocate` returns memory
/// aligned to `alignment` (a power of two) or null, and the call then answers out_of_memory.
struct Allocator {
  void* user = nullptr;
  void* (*allocate)(void* user, size_t bytes, size_t alignment) = nullptr;
  void (*deallocate)(void* user, void* memory, size_t bytes) = nullptr;
};

/// Receives every message of a context, on the thread that made the call; null means none.
/// Error texts read `<call>, cloth <index>: <problem> (<why it is a problem>) <what to do>`, the
/// cloth where the call is about one, and have at most 511 characters. A text is told eight times,
/// and then whenever its count has doubled, with the count; texts that differ by numbers alone are
/// told 128 times, and then as rarely.
struct Log {
  void* user = nullptr;
  void (*message)(void* user, Severity, const char* text) = nullptr;
};

/// The caller's own threads: with them weft opens no OpenMP region, in sorts neither. Both of
/// `workers` and `parallel_for`, or none.
struct Jobs {
  void* user = nullptr;
  uint32_t workers = 0;  ///< threads that parallel_for may use at once
  /// Calls fn(ctx, begin, end) for ranges that cover [0, count) once, each of about `grain` items,
  /// in any order on any threads, and returns when all are done. May be called from several threads
  /// where several worlds step at once. `name` is a literal.
  void (*parallel_for)(void* user, uint32_t count, uint32_t grain,
                       void (*fn)(void* ctx, uint32_t begin, uint32_t end), void* ctx,
                       const char* name) = nullptr;
  /// Optional: starts fn(ctx) on another thread and returns, for World::begin_step.
  void (*launch)(void* user, void (*fn)(void* ctx), void* ctx, const char* name) = nullptr;
};

/// Zones of a profiler: Tracy, Unreal Insights, Optick. Both functions or none. Called on the
/// thread that does the work; `name` is a literal. Zones: "weft cook", "weft prepare", "weft step"
/// (in a step in flight: its thread), "weft write_outputs".
struct Profiler {
  void* user = nullptr;
  void* (*zone_begin)(void* user, const char* name) = nullptr;
  void (*zone_end)(void* user, void* zone) = nullptr;  ///< `zone`: what zone_begin returned
};

enum class Precision : uint8_t { float32, float64 };
WEFT_API const char* to_string(Precision) noexcept;

}  // namespace v0
}  // namespace weft
