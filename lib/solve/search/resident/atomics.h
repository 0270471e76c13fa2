// Atomic integers for kernels, on host and device. They are relaxed, so results must not depend on
// the order of the threads: sums, minima, maxima, unions.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby::solve {

OBBY_DEVICE uint32_t fetchAdd(uint32_t* at, uint32_t value) {
#if defined(__CUDA_ARCH__)
  return atomicAdd(at, value);
#else
  return __atomic_fetch_add(at, value, __ATOMIC_RELAXED);
#endif
}

OBBY_DEVICE uint64_t fetchAdd(uint64_t* at, uint64_t value) {
#if defined(__CUDA_ARCH__)
  return atomicAdd(reinterpret_cast<unsigned long long*>(at), value);
#else
  return __atomic_fetch_add(at, value, __ATOMIC_RELAXED);
#endif
}

OBBY_DEVICE uint32_t fetchOr(uint32_t* at, uint32_t bits) {
#if defined(__CUDA_ARCH__)
  return atomicOr(at, bits);
#else
  return __atomic_fetch_or(at, bits, __ATOMIC_RELAXED);
#endif
}

// Returns the old value. Stores `value` if the old value was `expected`.
OBBY_DEVICE uint64_t compareExchange(uint64_t* at, uint64_t expected, uint64_t value) {
#if defined(__CUDA_ARCH__)
  return atomicCAS(reinterpret_cast<unsigned long long*>(at), expected, value);
#else
  __atomic_compare_exchange_n(at, &expected, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
  return expected;
#endif
}

#if !defined(__CUDA_ARCH__)
// Stores `value` if before(value, old value) is true, atomically.
template <class T, class Before>
OBBY_DEVICE void replaceWhile(T* at, T value, Before&& before) {
  T seen = __atomic_load_n(at, __ATOMIC_RELAXED);
  while (before(value, seen) &&
         !__atomic_compare_exchange_n(at, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
  }
}
#endif

OBBY_DEVICE void lower(uint32_t* at, uint32_t value) {
#if defined(__CUDA_ARCH__)
  atomicMin(at, value);
#else
  replaceWhile(at, value, [](uint32_t a, uint32_t b) { return a < b; });
#endif
}

OBBY_DEVICE void lower(uint64_t* at, uint64_t value) {
#if defined(__CUDA_ARCH__)
  atomicMin(reinterpret_cast<unsigned long long*>(at), value);
#else
  replaceWhile(at, value, [](uint64_t a, uint64_t b) { return a < b; });
#endif
}

OBBY_DEVICE void raise(uint32_t* at, uint32_t value) {
#if defined(__CUDA_ARCH__)
  atomicMax(at, value);
#else
  replaceWhile(at, value, [](uint32_t a, uint32_t b) { return a > b; });
#endif
}

OBBY_DEVICE uint32_t loadRelaxed(const uint32_t* at) {
#if defined(__CUDA_ARCH__)
  return *static_cast<const volatile uint32_t*>(at);
#else
  return __atomic_load_n(at, __ATOMIC_RELAXED);
#endif
}

OBBY_DEVICE void storeRelaxed(uint32_t* at, uint32_t value) {
#if defined(__CUDA_ARCH__)
  *static_cast<volatile uint32_t*>(at) = value;
#else
  __atomic_store_n(at, value, __ATOMIC_RELAXED);
#endif
}

}  // namespace obby::solve
