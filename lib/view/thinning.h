// Simplification of polylines.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace obby::view {

constexpr size_t kLongStretch = 4096;  // points

// Douglas-Peucker: returns ascending indices of points to keep, so that no point is farther than
// `min` from the kept line. `distance(a, b, p)` returns the distance of point p from the segment
// a to b, by index. Lines longer than kLongStretch may keep a few more.
template <class Distance>
std::vector<size_t> thinned(size_t count, float min, const Distance& distance) {
  std::vector<bool> kept(count, false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<size_t, size_t>> open = {{0, count - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    size_t farthest = first;
    float max = min;
    for (size_t i = first + 1; i < last; ++i) {
      const float off = distance(first, last, i);
      if (off <= max) continue;
      max = off;
      farthest = i;
    }
    if (farthest == first) continue;
    // On a line that runs in circles, the farthest point lies in the first round. Splitting off one
    // round at a time would take quadratic time, so a long stretch is halved.
    const size_t cut = last - first > kLongStretch ? first + (last - first) / 2 : farthest;
    kept[cut] = true;
    open.push_back({first, cut});
    open.push_back({cut, last});
  }
  std::vector<size_t> out;
  for (size_t i = 0; i < count; ++i) {
    if (kept[i]) out.push_back(i);
  }
  return out;
}

}  // namespace obby::view
