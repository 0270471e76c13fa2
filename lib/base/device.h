// The one macro that marks code for host and device, and the one for SIMD lanes (host only).
// Headers of modules marked [device] in CONTRIBUTING.md use it on every function and keep to: no
// exceptions, no allocation, no virtual calls, no statics, no standard containers.
#pragma once

// Code for the CPU's lanes, which is worth nothing unless it is inlined.
#define OBBY_LANES inline __attribute__((always_inline))

// OBBY_APART is for what is large and runs rarely: a function of its own, which leaves the caches
// and the compiler's time to the rest.
// OBBY_CALLED is for what is large and called from many places: on the CPU a function of its own,
// for the compiler's time; on a GPU, where a call forces registers out to memory, inlined.
// OBBY_INLINED follows the parameters of a lambda that must not become a function of its own.
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
