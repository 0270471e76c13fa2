// Fewer points for the same way.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace obby::view {

constexpr size_t kLongStretch = 4096;  // points

// Douglas and Peucker: indices, ascending, of the points that are needed so that none is farther
// than `least` from the line through those kept. `distance(a, b, p)`: of point p from the stretch
// from a to b, by index. Of a way longer than kLongStretch a few more may be kept.
template <class Distance>
std::vector<size_t> thinned(size_t count, float least, const Distance& distance) {
  std::vector<bool> kept(count, false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<size_t, size_t>> open = {{0, count - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    size_t farthest = first;
    float most = least;
    for (size_t i = first + 1; i < last; ++i) {
      const float off = distance(first, last, i);
      if (off <= most) continue;
      most = off;
      farthest = i;
    }
    if (farthest == first) continue;
    // On a way in circles the farthest is in the first round: taken off round by round, hours of it
    // would take a time that grows with their square. So a long stretch is halved.
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
