#include "api/context/registry.h"

#include "base/message_host.h"

namespace weft {

// Each optional back end is one factory; it returns null and a reason where it has no device.
#ifdef WEFT_HAVE_OMP_v2
const Backend& backend_omp_v2();
#endif
#ifdef WEFT_HAVE_OMP_v3
const Backend& backend_omp_v3();
#endif
#ifdef WEFT_HAVE_OMP_v4
const Backend& backend_omp_v4();
#endif
#ifdef WEFT_HAVE_CUDA
const Backend* backend_cuda(const char** reason);
#endif
#ifdef WEFT_HAVE_HIP
const Backend* backend_hip(const char** reason);
#endif

namespace api {

namespace {

bool processor_has(Isa level) {
#if defined(__x86_64__)
  __builtin_cpu_init();
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                  __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  if (level == Isa::v3) return v3;
  if (level == Isa::v4) {
    return v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return level == Isa::v2;
}

const Backend* host_backend(Isa level) {
  if (!processor_has(level)) return nullptr;
  switch (level) {
#ifdef WEFT_HAVE_OMP_v2
    case Isa::v2:
      return &backend_omp_v2();
#endif
#ifdef WEFT_HAVE_OMP_v3
    case Isa::v3:
      return &backend_omp_v3();
#endif
#ifdef WEFT_HAVE_OMP_v4
    case Isa::v4:
      return &backend_omp_v4();
#endif
    default:
      return nullptr;
  }
}

const char* name_of(Isa level) {
  switch (level) {
    case Isa::v2:
      return "v2";
    case Isa::v3:
      return "v3";
    case Isa::v4:
      return "v4";
    default:
      return "auto";
  }
}

BackendChoice choose_host(Isa level) {
  BackendChoice choice;
  if (level != Isa::automatic) {
    choice.backend = host_backend(level);
    if (!choice.backend) {
      choice.refusal = text(
          "instruction level %s is not available (this processor or this build "
          "lacks it) use auto or a lower level",
          name_of(level));
    }
    return choice;
  }
  for (const Isa candidate : {Isa::v4, Isa::v3, Isa::v2}) {
    choice.backend = host_backend(candidate);
    if (choice.backend) return choice;
  }
  choice.refusal = "no host back end fits (the processor lacks x86-64-v2) build weft for it";
  return choice;
}

const Backend* gpu_backend(BackendKind kind, const char** reason) {
  *reason = nullptr;
  const bool any = kind == BackendKind::automatic;
  (void)any;
#ifdef WEFT_HAVE_CUDA
  if (any || kind == BackendKind::cuda) return backend_cuda(reason);
#endif
#ifdef WEFT_HAVE_HIP
  if (any || kind == BackendKind::hip) return backend_hip(reason);
#endif
  return nullptr;
}

}  // namespace

BackendChoice choose_backend(BackendKind kind, Isa level) {
  if (kind == BackendKind::omp) return choose_host(level);
  const char* reason = nullptr;
  const Backend* gpu = gpu_backend(kind, &reason);
  if (gpu) return {gpu, {}, {}};
  if (kind == BackendKind::automatic) {
    BackendChoice choice = choose_host(level);
    if (reason) {
      choice.fallback = text("the GPU is not used (%s) the host back end runs instead", reason);
    }
    return choice;
  }
  const char* name = kind == BackendKind::cuda ? "cuda" : "hip";
  return {nullptr,
          text("back end %s is not available (%s) use auto or omp", name,
               reason ? reason : "this build does not contain it"),
          {}};
}

}  // namespace api
}  // namespace weft
