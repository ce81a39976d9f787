#include "base/message_host.h"
#include "weft/weft.hpp"

namespace weft {
inline namespace v0 {

const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::invalid_argument:
      return "invalid_argument";
    case Status::invalid_handle:
      return "invalid_handle";
    case Status::version_mismatch:
      return "version_mismatch";
    case Status::out_of_memory:
      return "out_of_memory";
    case Status::no_device:
      return "no_device";
    case Status::device_lost:
      return "device_lost";
    case Status::unsupported:
      return "unsupported";
    case Status::unstable_step:
      return "unstable_step";
    case Status::diverged:
      return "diverged";
    case Status::wrong_thread:
      return "wrong_thread";
    case Status::in_flight:
      return "in_flight";
  }
  return "unknown";
}

const char* to_string(Precision precision) noexcept {
  return precision == Precision::float64 ? "float64" : "float32";
}

const char* to_string(Stencil stencil) noexcept {
  switch (stencil) {
    case Stencil::seed12:
      return "seed12";
    case Stencil::classic12:
      return "classic12";
    case Stencil::quad4:
      return "quad4";
    case Stencil::tri6:
      return "tri6";
  }
  return "unknown";
}

const char* to_string(Evaluation evaluation) noexcept {
  switch (evaluation) {
    case Evaluation::automatic:
      return "auto";
    case Evaluation::gather:
      return "gather";
    case Evaluation::scatter:
      return "scatter";
  }
  return "unknown";
}

const char* to_string(Accumulate accumulate) noexcept {
  switch (accumulate) {
    case Accumulate::native:
      return "native";
    case Accumulate::atomic:
      return "atomic";
    case Accumulate::fixed64:
      return "fixed64";
    case Accumulate::float16:
      return "float16";
    case Accumulate::float24:
      return "float24";
    case Accumulate::float24_all:
      return "float24_all";
    case Accumulate::fixed8:
      return "fixed8";
  }
  return "unknown";
}

const char* to_string(EventType type) noexcept {
  switch (type) {
    case EventType::non_finite:
      return "non_finite";
    case EventType::backend_fallback:
      return "backend_fallback";
    case EventType::slept:
      return "slept";
    case EventType::woke:
      return "woke";
    case EventType::time_dropped:
      return "time_dropped";
    case EventType::force_overflow:
      return "force_overflow";
    case EventType::large_stretch:
      return "large_stretch";
    case EventType::energy_growth:
      return "energy_growth";
  }
  return "unknown";
}

#if defined(__clang__)
#  define WEFT_COMPILER "clang++ " __clang_version__
#else
#  define WEFT_COMPILER "g++ " __VERSION__
#endif

const char* build_info() noexcept {
  static const Text info = text("%d.%d.%d omp%s " WEFT_COMPILER, WEFT_VERSION_MAJOR,
                                WEFT_VERSION_MINOR, WEFT_VERSION_PATCH,
#ifdef WEFT_HAVE_CUDA
                                " cuda"
#else
                                ""
#endif
  );
  return info.c_str();
}

}  // namespace v0
}  // namespace weft
