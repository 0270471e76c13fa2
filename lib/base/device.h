// Macros that mark code for host and device, and for SIMD lanes (host only). Headers of modules
// marked [device] in CONTRIBUTING.md use them on every function. Those modules use no exceptions,
// allocation, virtual calls, statics or standard containers.
#pragma once

// Marks code for the CPU's SIMD lanes, which is slow unless it is inlined.
#define OBBY_LANES inline __attribute__((always_inline))

// OBBY_APART marks a large function that runs rarely. It is not inlined, which saves instruction
// cache and compile time.
// OBBY_CALLED marks a large function with many callers. On the CPU it is not inlined, to save
// compile time. On a GPU it is inlined, because a call there spills registers to memory.
// OBBY_INLINED follows the parameters of a lambda that must be inlined.
#if defined(__CUDACC__)
#define OBBY_INLINED
#define OBBY_DEVICE __host__ __device__ __forceinline__
#define OBBY_APART __host__ __device__ __noinline__ inline
#define OBBY_CALLED OBBY_DEVICE
#else
#define OBBY_INLINED __attribute__((always_inline))
#define OBBY_DEVICE OBBY_LANES
#define OBBY_APART inline __attribute__((noinline))
#define OBBY_CALLED OBBY_APART
#endif
