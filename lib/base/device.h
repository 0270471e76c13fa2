// The one macro that marks code for host and device. Headers of modules marked [device] in
// CONTRIBUTING.md use it on every function and keep to: no exceptions, no allocation, no virtual
// calls, no statics, no standard containers.
#pragma once

#if defined(__CUDACC__)
#define OBBY_DEVICE __host__ __device__ __forceinline__
#else
#define OBBY_DEVICE inline __attribute__((always_inline))
#endif
