// The only file that asks which compiler reads it. Everything else uses the words defined here.
//
//   WEFT_HD          function that runs on host and device (always inlined on the host: clang does
//                    not vectorise a loop that calls)
//   WEFT_HD_COLD     the same for a stage that is rare: the host keeps one copy of it
//   WEFT_LANE        goes between the parameter list and the body of a lane lambda
//   WEFT_SIMD        before a loop over the lanes of a block
//   WEFT_SIMD_OR     the same for a loop that combines `found` with |
//   WEFT_UNROLL      before a loop of constant length that must disappear
//   WEFT_BACKEND_NS  namespace of everything that this compilation turns into code: two copies of a
//                    function never share a symbol, so the linker cannot keep the wrong one
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__HIPCC__) || defined(__CUDACC__)
#  define WEFT_HD __host__ __device__
#  define WEFT_HD_COLD __host__ __device__
#  define WEFT_LANE
#  define WEFT_SIMD
#  define WEFT_SIMD_OR(found)
#else
#  define WEFT_HD __attribute__((always_inline)) inline
#  define WEFT_HD_COLD __attribute__((noinline))
#  define WEFT_LANE __attribute__((always_inline))
#  define WEFT_SIMD _Pragma("omp simd")
#  define WEFT_PRAGMA(text) _Pragma(#  text)
#  define WEFT_SIMD_OR(found) WEFT_PRAGMA(omp simd reduction(| : found))
#endif

#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
#  define WEFT_UNROLL _Pragma("unroll")
#elif defined(__HIPCC__) || defined(__CUDACC__)
#  define WEFT_UNROLL
#else
#  define WEFT_UNROLL _Pragma("GCC unroll 16")
#endif

/// Value of a lane `by` lanes further up the warp; on the host a kernel has no warp.
#if defined(__HIP_DEVICE_COMPILE__)
#  define WEFT_SHUFFLE_DOWN(value, by) __shfl_down(value, static_cast<unsigned>(by), 32)
#elif defined(__CUDA_ARCH__)
#  define WEFT_SHUFFLE_DOWN(value, by) __shfl_down_sync(~0u, value, by)
#else
#  define WEFT_SHUFFLE_DOWN(value, by) (value)
#endif

/// Value of lane 0 of the warp.
#if defined(__HIP_DEVICE_COMPILE__)
#  define WEFT_OF_FIRST_LANE(value) __shfl(value, 0, 32)
#elif defined(__CUDA_ARCH__)
#  define WEFT_OF_FIRST_LANE(value) __shfl_sync(~0u, value, 0)
#else
#  define WEFT_OF_FIRST_LANE(value) (value)
#endif

/// The first where a GPU runs this, the second on the host.
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
#  define WEFT_DEVICE_OR_HOST(device, host) device
#else
#  define WEFT_DEVICE_OR_HOST(device, host) host
#endif

#ifndef WEFT_BACKEND_NS
#  define WEFT_BACKEND_NS host
#endif

/// Bit mask of stages that are not compiled (state/stages.h): none, but for a test.
#ifndef WEFT_LEAVE_OUT_STAGES
#  define WEFT_LEAVE_OUT_STAGES 0u
#endif

/// Scalars from one vector to the next in an array of vectors: 1 stores x, y and z apart
/// (structure of arrays), 4 stores x, y, z and a pad together. Bits do not depend on it.
#ifndef WEFT_VECTOR_STRIDE
#  define WEFT_VECTOR_STRIDE 1
#endif

/// Whether a host's substep is one pass (step/pipeline.h): yes, but for a test of what a GPU does.
#ifndef WEFT_FUSE_PASSES
#  define WEFT_FUSE_PASSES true
#endif

namespace weft {

/// Particles that share one control flow: a GPU warp, or a few CPU vectors.
constexpr int block_size = 32;

/// Springs of the longest row that stays in its slice, and entries of a chunk of a longer one, a
/// multiple of block_size (state/springs.h).
constexpr int hub_valence = 128;
constexpr int hub_chunk = 1024;

}  // namespace weft
