// Short lists that are as long as each lane needs. For one world a list is an array and a count.
// Many worlds (simd/wide_list.h) use an array with a count for each lane.
#pragma once

#include "math/vec.h"

namespace obby {

// At most kMax items of type T. T may only have members of the number type F. Items past the end
// are unspecified.
template <class T, class F, int kMax>
struct LaneList;

template <class T, int kMax>
struct LaneList<T, float, kMax> {
  int32_t count = 0;

  OBBY_DEVICE LaneList() { items_[0] = {}; }  // at(0) of an empty list is read, but not used
  OBBY_DEVICE void clear() { count = 0; }
  OBBY_DEVICE T at(int32_t i) const { return items_[i]; }
  // Returns the item after the i-th; the first item follows the last.
  OBBY_DEVICE T next(int32_t i) const { return items_[i + 1 < count ? i + 1 : 0]; }
  // Adds the item if `asked`. Drops it if the list is full.
  OBBY_DEVICE void add(bool asked, const T& item) {
    if (asked && count < kMax) items_[count++] = item;
  }

 private:
  union {  // leaves the array uninitialised
    T items_[kMax];
  };
};

}  // namespace obby
