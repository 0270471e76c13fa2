// Converts rows to lanes and back. kLanes structs, each of which starts with 16 words of 32 bits,
// become 16 wide words. A row is one cache line, so this is faster than gathering word by word.
#pragma once

#include <string.h>

#include "simd/wide.h"

namespace obby {

constexpr int kRowWords = 16;

struct Rows {
  WideInt word[kRowWords];
};

#if defined(__AVX512F__)

namespace internal {

// A mask of all lanes. Intrinsics without a mask make g++ 12 warn of undefined operands (its bug
// 105593).
constexpr __mmask16 kAll = 0xffff;

// Transposes 16 rows of 16 words. It is its own inverse.
OBBY_LANES void transpose(__m512i r[16]) {
  __m512i t[16];
  for (int i = 0; i < 16; i += 2) {
    t[i] = _mm512_maskz_unpacklo_epi32(kAll, r[i], r[i + 1]);
    t[i + 1] = _mm512_maskz_unpackhi_epi32(kAll, r[i], r[i + 1]);
  }
  for (int i = 0; i < 16; i += 4) {
    r[i] = _mm512_maskz_unpacklo_epi64(__mmask8(kAll), t[i], t[i + 2]);
    r[i + 1] = _mm512_maskz_unpackhi_epi64(__mmask8(kAll), t[i], t[i + 2]);
    r[i + 2] = _mm512_maskz_unpacklo_epi64(__mmask8(kAll), t[i + 1], t[i + 3]);
    r[i + 3] = _mm512_maskz_unpackhi_epi64(__mmask8(kAll), t[i + 1], t[i + 3]);
  }
  for (int half = 0; half < 16; half += 8) {
    for (int i = half; i < half + 4; ++i) {
      t[i] = _mm512_maskz_shuffle_i32x4(kAll, r[i], r[i + 4], 0x88);
      t[i + 4] = _mm512_maskz_shuffle_i32x4(kAll, r[i], r[i + 4], 0xdd);
    }
  }
  for (int i = 0; i < 8; ++i) {
    r[i] = _mm512_maskz_shuffle_i32x4(kAll, t[i], t[i + 8], 0x88);
    r[i + 8] = _mm512_maskz_shuffle_i32x4(kAll, t[i], t[i + 8], 0xdd);
  }
}

}  // namespace internal

OBBY_LANES Rows loadRows(const void* const* rows) {
  __m512i r[16];
  for (int i = 0; i < 16; ++i) r[i] = _mm512_loadu_si512(rows[i]);
  internal::transpose(r);
  Rows out;
  for (int i = 0; i < 16; ++i) out.word[i] = WideInt(internal::IntLanes(r[i]));
  return out;
}

OBBY_LANES void storeRows(const Rows& in, void* const* rows) {
  __m512i r[16];
  for (int i = 0; i < 16; ++i) r[i] = static_cast<__m512i>(in.word[i].v);
  internal::transpose(r);
  for (int i = 0; i < 16; ++i) _mm512_storeu_si512(rows[i], r[i]);
}

#else

OBBY_LANES Rows loadRows(const void* const* rows) {
  int32_t words[kRowWords][kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    int32_t row[kRowWords];
    memcpy(row, rows[lane], sizeof row);
    for (int i = 0; i < kRowWords; ++i) words[i][lane] = row[i];
  }
  Rows out;
  for (int i = 0; i < kRowWords; ++i) out.word[i] = load(words[i]);
  return out;
}

OBBY_LANES void storeRows(const Rows& in, void* const* rows) {
  int32_t words[kRowWords][kLanes];
  for (int i = 0; i < kRowWords; ++i) store(in.word[i], words[i]);
  for (int lane = 0; lane < kLanes; ++lane) {
    int32_t row[kRowWords];
    for (int i = 0; i < kRowWords; ++i) row[i] = words[i][lane];
    memcpy(rows[lane], row, sizeof row);
  }
}

#endif

}  // namespace obby
