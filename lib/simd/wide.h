// WideFloat holds as many floats as the CPU has SIMD lanes, for the templates of math/lanes.h. Host
// only. It is built on std::experimental::simd; gathers and packed stores, which it lacks, are
// below. The width follows the compiler's target (16 with AVX-512, 8 with AVX, 4 otherwise) and
// never affects a result.
#pragma once

#include <stdint.h>

#include <experimental/simd>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "math/lanes.h"

namespace obby {

namespace internal {
namespace stdx = std::experimental;
using FloatLanes = stdx::native_simd<float>;
using IntLanes = stdx::rebind_simd_t<int32_t, FloatLanes>;
using FloatMask = FloatLanes::mask_type;
using IntMask = IntLanes::mask_type;
static_assert(IntLanes::size() == FloatLanes::size(), "one integer a float");
static_assert(sizeof(IntMask) == sizeof(FloatMask), "masks of both are the same bits");

#if defined(__AVX512F__)
// where() of libstdc++ 12 is wrong here when clang 14 compiles it.
OBBY_LANES FloatLanes blend(FloatMask choose, FloatLanes yes, FloatLanes no) {
  const auto bits = __builtin_bit_cast(__mmask16, choose);
  return FloatLanes(_mm512_mask_blend_ps(bits, static_cast<__m512>(no), static_cast<__m512>(yes)));
}
OBBY_LANES IntLanes blend(IntMask choose, IntLanes yes, IntLanes no) {
  const auto bits = __builtin_bit_cast(__mmask16, choose);
  return IntLanes(
      _mm512_mask_blend_epi32(bits, static_cast<__m512i>(no), static_cast<__m512i>(yes)));
}
OBBY_LANES FloatLanes root(FloatLanes v) {
  return FloatLanes(_mm512_maskz_sqrt_ps(0xffff, static_cast<__m512>(v)));
}
#else
OBBY_LANES FloatLanes root(FloatLanes v) { return stdx::sqrt(v); }
template <class Mask, class Value>
OBBY_LANES Value blend(Mask choose, Value yes, Value no) {
  stdx::where(choose, no) = yes;
  return no;
}
#endif

// a < b ? a : b and a > b ? a : b. One instruction does exactly this, for NaN and zeros, too.
#if defined(__AVX512F__)
OBBY_LANES FloatLanes lesser(FloatLanes a, FloatLanes b) {
  return FloatLanes(_mm512_maskz_min_ps(0xffff, static_cast<__m512>(a), static_cast<__m512>(b)));
}
OBBY_LANES FloatLanes greater(FloatLanes a, FloatLanes b) {
  return FloatLanes(_mm512_maskz_max_ps(0xffff, static_cast<__m512>(a), static_cast<__m512>(b)));
}
#elif defined(__AVX__)
OBBY_LANES FloatLanes lesser(FloatLanes a, FloatLanes b) {
  return FloatLanes(_mm256_min_ps(static_cast<__m256>(a), static_cast<__m256>(b)));
}
OBBY_LANES FloatLanes greater(FloatLanes a, FloatLanes b) {
  return FloatLanes(_mm256_max_ps(static_cast<__m256>(a), static_cast<__m256>(b)));
}
#elif defined(__x86_64__)
OBBY_LANES FloatLanes lesser(FloatLanes a, FloatLanes b) {
  return FloatLanes(_mm_min_ps(static_cast<__m128>(a), static_cast<__m128>(b)));
}
OBBY_LANES FloatLanes greater(FloatLanes a, FloatLanes b) {
  return FloatLanes(_mm_max_ps(static_cast<__m128>(a), static_cast<__m128>(b)));
}
#else
OBBY_LANES FloatLanes lesser(FloatLanes a, FloatLanes b) { return blend(a < b, a, b); }
OBBY_LANES FloatLanes greater(FloatLanes a, FloatLanes b) { return blend(a > b, a, b); }
#endif
}  // namespace internal

struct WideMask {
  internal::FloatMask v;

  OBBY_LANES WideMask(bool all = false) : v(all) {}  // NOLINT(google-explicit-constructor)
  OBBY_LANES explicit WideMask(internal::FloatMask lanes) : v(lanes) {}

  friend OBBY_LANES WideMask operator&(WideMask a, WideMask b) { return WideMask(a.v && b.v); }
  friend OBBY_LANES WideMask operator|(WideMask a, WideMask b) { return WideMask(a.v || b.v); }
  friend OBBY_LANES WideMask operator!(WideMask a) { return WideMask(!a.v); }
  friend OBBY_LANES WideMask& operator&=(WideMask& a, WideMask b) { return a = a & b; }
  friend OBBY_LANES WideMask& operator|=(WideMask& a, WideMask b) { return a = a | b; }
  friend OBBY_LANES bool any(WideMask m) { return internal::stdx::any_of(m.v); }
  friend OBBY_LANES bool all(WideMask m) { return internal::stdx::all_of(m.v); }
};

struct WideInt {
  internal::IntLanes v{};

  WideInt() = default;
  OBBY_LANES WideInt(int32_t all) : v(all) {}  // NOLINT(google-explicit-constructor)
  OBBY_LANES explicit WideInt(internal::IntLanes lanes) : v(lanes) {}

  friend OBBY_LANES WideInt operator+(WideInt a, WideInt b) { return WideInt(a.v + b.v); }
  friend OBBY_LANES WideInt operator-(WideInt a, WideInt b) { return WideInt(a.v - b.v); }
  friend OBBY_LANES WideInt operator*(WideInt a, WideInt b) { return WideInt(a.v * b.v); }
  friend OBBY_LANES WideInt operator&(WideInt a, WideInt b) { return WideInt(a.v & b.v); }
  friend OBBY_LANES WideInt operator|(WideInt a, WideInt b) { return WideInt(a.v | b.v); }
  friend OBBY_LANES WideInt operator<<(WideInt a, int by) { return WideInt(a.v << by); }
  friend OBBY_LANES WideInt operator>>(WideInt a, int by) { return WideInt(a.v >> by); }
  friend OBBY_LANES WideMask operator==(WideInt a, WideInt b) { return toMask(a.v == b.v); }
  friend OBBY_LANES WideMask operator!=(WideInt a, WideInt b) { return toMask(a.v != b.v); }
  friend OBBY_LANES WideMask operator<(WideInt a, WideInt b) { return toMask(a.v < b.v); }
  friend OBBY_LANES WideMask operator>(WideInt a, WideInt b) { return toMask(a.v > b.v); }
  friend OBBY_LANES WideMask operator<=(WideInt a, WideInt b) { return toMask(a.v <= b.v); }
  friend OBBY_LANES WideMask operator>=(WideInt a, WideInt b) { return toMask(a.v >= b.v); }
  friend OBBY_LANES WideInt select(WideMask choose, WideInt yes, WideInt no) {
    return WideInt(internal::blend(__builtin_bit_cast(internal::IntMask, choose.v), yes.v, no.v));
  }

 private:
  static OBBY_LANES WideMask toMask(internal::IntMask m) {
    return WideMask(__builtin_bit_cast(internal::FloatMask, m));
  }
};

struct WideFloat {
  internal::FloatLanes v{};

  WideFloat() = default;
  OBBY_LANES WideFloat(float all) : v(all) {}  // NOLINT(google-explicit-constructor)
  OBBY_LANES explicit WideFloat(internal::FloatLanes lanes) : v(lanes) {}

  friend OBBY_LANES WideFloat operator+(WideFloat a, WideFloat b) { return WideFloat(a.v + b.v); }
  friend OBBY_LANES WideFloat operator-(WideFloat a, WideFloat b) { return WideFloat(a.v - b.v); }
  friend OBBY_LANES WideFloat operator-(WideFloat a) { return WideFloat(-a.v); }
  friend OBBY_LANES WideFloat operator*(WideFloat a, WideFloat b) { return WideFloat(a.v * b.v); }
  friend OBBY_LANES WideFloat operator/(WideFloat a, WideFloat b) { return WideFloat(a.v / b.v); }
  friend OBBY_LANES WideFloat& operator+=(WideFloat& a, WideFloat b) { return a = a + b; }
  friend OBBY_LANES WideFloat& operator-=(WideFloat& a, WideFloat b) { return a = a - b; }
  friend OBBY_LANES WideFloat& operator*=(WideFloat& a, WideFloat b) { return a = a * b; }
  friend OBBY_LANES WideMask operator<(WideFloat a, WideFloat b) { return WideMask(a.v < b.v); }
  friend OBBY_LANES WideMask operator>(WideFloat a, WideFloat b) { return WideMask(a.v > b.v); }
  friend OBBY_LANES WideMask operator<=(WideFloat a, WideFloat b) { return WideMask(a.v <= b.v); }
  friend OBBY_LANES WideMask operator>=(WideFloat a, WideFloat b) { return WideMask(a.v >= b.v); }
  friend OBBY_LANES WideMask operator==(WideFloat a, WideFloat b) { return WideMask(a.v == b.v); }
  friend OBBY_LANES WideMask operator!=(WideFloat a, WideFloat b) { return WideMask(a.v != b.v); }
  friend OBBY_LANES WideFloat select(WideMask choose, WideFloat yes, WideFloat no) {
    return WideFloat(internal::blend(choose.v, yes.v, no.v));
  }
  friend OBBY_LANES WideFloat minf(WideFloat a, WideFloat b) {
    return WideFloat(internal::lesser(a.v, b.v));
  }
  friend OBBY_LANES WideFloat maxf(WideFloat a, WideFloat b) {
    return WideFloat(internal::greater(a.v, b.v));
  }
  friend OBBY_LANES WideFloat absf(WideFloat a) { return WideFloat(internal::stdx::abs(a.v)); }
  friend OBBY_LANES WideFloat sqrtf32(WideFloat a) { return WideFloat(internal::root(a.v)); }
};

template <>
struct Lanes<WideFloat> {
  using Int = WideInt;
  using Mask = WideMask;
  static constexpr int kCount = int(internal::FloatLanes::size());
};

constexpr int kLanes = Lanes<WideFloat>::kCount;

OBBY_LANES WideFloat toFloat(WideInt a) {
  return WideFloat(internal::stdx::static_simd_cast<internal::FloatLanes>(a.v));
}
OBBY_LANES WideInt toInt(WideFloat a) {  // toward zero
  return WideInt(internal::stdx::static_simd_cast<internal::IntLanes>(a.v));
}

// Reinterprets the same 32 bits as the other type.
OBBY_LANES WideInt bitsOf(WideFloat a) { return __builtin_bit_cast(WideInt, a); }
OBBY_LANES WideFloat floatOfBits(WideInt a) { return __builtin_bit_cast(WideFloat, a); }

// Loads or stores kLanes consecutive values without any alignment.
OBBY_LANES WideFloat load(const float* from) {
  return WideFloat(internal::FloatLanes(from, internal::stdx::element_aligned));
}
OBBY_LANES WideInt load(const int32_t* from) {
  return WideInt(internal::IntLanes(from, internal::stdx::element_aligned));
}
OBBY_LANES void store(WideFloat a, float* to) { a.v.copy_to(to, internal::stdx::element_aligned); }
OBBY_LANES void store(WideInt a, int32_t* to) { a.v.copy_to(to, internal::stdx::element_aligned); }

// Loads lane k from base[index[k]].
OBBY_LANES WideFloat gather(const float* base, const int32_t* index) {
#if defined(__AVX512F__)
  const __m512i at = _mm512_loadu_si512(index);
  return WideFloat(
      internal::FloatLanes(_mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xffff, at, base, 4)));
#else
  return WideFloat(internal::FloatLanes([=](auto k) { return base[index[k]]; }));
#endif
}

// Returns the number of each lane: 0, 1, ...
OBBY_LANES WideInt laneNumbers() {
  return WideInt(internal::IntLanes([](auto k) { return int32_t(k); }));
}

// Returns a mask whose bit k is lane k.
OBBY_LANES uint32_t bitsOf(WideMask m) {
  uint32_t bits = 0;
#if defined(__AVX512F__)
  bits = __builtin_bit_cast(uint16_t, m.v);
#else
  for (int k = 0; k < kLanes; ++k) bits |= uint32_t(m.v[size_t(k)]) << k;
#endif
  return bits;
}

// Packs the lanes of `chosen` into `to`, which must hold kLanes values. The values after the packed
// ones are unspecified.
OBBY_LANES void storeChosen(WideFloat a, uint32_t chosen, float* to) {
#if defined(__AVX512F__)
  const auto lanes = _mm512_maskz_compress_ps(__mmask16(chosen), static_cast<__m512>(a.v));
  _mm512_storeu_ps(to, lanes);
#else
  for (; chosen != 0; chosen &= chosen - 1) *to++ = a.v[size_t(__builtin_ctz(chosen))];
#endif
}

}  // namespace obby
