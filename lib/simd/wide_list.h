// The lists of math/lane_list.h for lanes of worlds. Host only.
#pragma once

#include "math/lane_list.h"
#include "simd/wide.h"

namespace obby {

template <class T, int kMax>
struct LaneList<T, WideFloat, kMax> {
  WideInt count{0};

  OBBY_LANES LaneList() {
    for (auto& word : rows_[0]) store(WideFloat(0.0f), word);
  }
  OBBY_LANES void clear() {
    count = WideInt(0);
    longest_ = 0;
  }
  OBBY_LANES T at(int i) const {
    Words out;
    for (int w = 0; w < kWords; ++w) out.word[w] = load(rows_[i][w]);
    return __builtin_bit_cast(T, out);
  }
  OBBY_LANES T at(WideInt i) const {
    alignas(64) int32_t index[kLanes];
    store(i * (kWords * kLanes) + laneNumbers(), index);
    Words out;
    for (int w = 0; w < kWords; ++w) out.word[w] = gather(rows_[0][w], index);
    return __builtin_bit_cast(T, out);
  }
  OBBY_LANES T next(int i) const {
    const T first = at(0);
    return i + 1 < kMax ? select(count > i + 1, at(i + 1), first) : first;
  }
  // Lanes whose lists have the same length store together. This is faster than scattering while
  // lists are short.
  OBBY_LANES void add(WideMask asked, const T& item) {
    const WideMask fits = asked & (count < kMax);
    if (!any(fits)) return;
    const Words in = __builtin_bit_cast(Words, item);
    for (int i = 0; i <= longest_ && i < kMax; ++i) {
      const WideMask here = fits & (count == i);
      for (int w = 0; w < kWords; ++w) {
        store(select(here, in.word[w], load(rows_[i][w])), rows_[i][w]);
      }
    }
    ++longest_;
    count = count + select(fits, WideInt(1), WideInt(0));
  }

 private:
  int longest_ = 0;  // upper bound on the length of every lane
  static constexpr int kWords = int(sizeof(T) / sizeof(WideFloat));
  struct Words {
    WideFloat word[kWords];
  };
  union {
    alignas(64) float rows_[kMax][kWords][kLanes];
  };
};

}  // namespace obby
