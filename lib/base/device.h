// The one macro that marks code for host and device, and the one for SIMD lanes (host only).
// Headers of modules marked [device] in CONTRIBUTING.md use it on every function and keep to: no
// exceptions, no allocation, no virtual calls, no statics, no standard containers.
#pragma once

// Code for the CPU's lanes, which is worth nothing unless it is inlined.
#define OBBY_LANES inline __attribute__((always_inline))

#if defined(__CUDACC__)
#define OBBY_DEVICE __host__ __device__ __forceinline__
#else
#define OBBY_DEVICE OBBY_LANES
#endif
