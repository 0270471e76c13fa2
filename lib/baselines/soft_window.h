// Sub-goals on the way to a goal. A player that reaches one within a window ahead has also passed
// the ones before it. Host only.
#pragma once

#include "baselines/names.h"

#include <algorithm>
#include <cstddef>

namespace obby::baselines {

constexpr size_t kWindow = 10;  // sub-goals

// `next`: index of the first of `count` sub-goals that is not reached. Moves it past the last i in
// next, ..., next + kWindow - 1 for which reached(i) holds. Returns true if it moved.
template <class Reached>
bool passSubgoals(size_t& next, size_t count, Reached&& reached) {
  for (size_t i = std::min(next + kWindow, count); i-- > next;) {
    if (!reached(i)) continue;
    next = i + 1;
    return true;
  }
  return false;
}

}  // namespace obby::baselines
