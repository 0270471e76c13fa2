// Sub-goals on the way to a goal: to be reached in their order, but whoever reaches one of those
// ahead within a window has passed the ones before it, too. Host only.
#pragma once

#include <algorithm>
#include <cstddef>

namespace obby::solve::learned {

constexpr size_t kWindow = 10;  // sub-goals

// `next`: the first of `count` sub-goals that is not reached. If reached(i) holds for some i of
// next, ..., next + kWindow - 1, `next` becomes the one after the last such. True: it moved.
template <class Reached>
bool passSubgoals(size_t& next, size_t count, Reached&& reached) {
  for (size_t i = std::min(next + kWindow, count); i-- > next;) {
    if (!reached(i)) continue;
    next = i + 1;
    return true;
  }
  return false;
}

}  // namespace obby::solve::learned
