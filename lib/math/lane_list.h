// Short lists that are as long as each lane needs: of one world an array and a count, of many
// (simd/wide_list.h) an array and a count for each lane.
#pragma once

#include "math/vec.h"

namespace obby {

// At most kMost items of type T, which holds numbers F and nothing else. What is past the end is
// not meant.
template <class T, class F, int kMost>
struct LaneList;

template <class T, int kMost>
struct LaneList<T, float, kMost> {
  int32_t count = 0;

  OBBY_DEVICE LaneList() { items_[0] = {}; }  // read where a list is empty, for nothing
  OBBY_DEVICE void clear() { count = 0; }
  OBBY_DEVICE T at(int32_t i) const { return items_[i]; }
  // The item after the i-th; after the last comes the first.
  OBBY_DEVICE T next(int32_t i) const { return items_[i + 1 < count ? i + 1 : 0]; }
  // What does not fit is left out.
  OBBY_DEVICE void add(bool asked, const T& item) {
    if (asked && count < kMost) items_[count++] = item;
  }

 private:
  union {  // keeps the array from being filled
    T items_[kMost];
  };
};

}  // namespace obby
