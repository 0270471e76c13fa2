// How much of a report goes into a page: browsers grow slow beyond some 20 MB.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "view/report.h"

namespace obby::view {

constexpr size_t kPageTarget = 20u << 20;  // bytes; beyond it data is thinned out
constexpr size_t kPageLimit = 200u << 20;  // bytes; no larger page is written

struct Budget {
  uint32_t attemptStride = 1;      // every n-th tick of failed attempts; solutions keep all
  uint32_t trackStride = 1;        // every n-th tick of moving parts
  uint32_t attemptsOneOf = 1;      // every n-th failed attempt is kept
  std::vector<std::string> notes;  // what was thinned out, for people
};

// Ticks of each level's clock that the page has to show.
std::vector<uint32_t> ticksShown(const Report& report);
// Of a level without trajectories.
uint32_t leastTicksShown(const LevelEntry& level);

// How large the page's data is when nothing is thinned out, about, in bytes.
struct PageSizes {
  size_t fixed = 0, attempts = 0, tracks = 0;
  size_t whole = 0;         // of attempts, what no stride thins out: loose bodies, actions, numbers
  bool longMotion = false;  // of some part there is more than a page shows

  // `ticks` of motion are shown.
  void add(const LevelEntry& level, uint32_t ticks);
  void add(const QueryEntry& query);
};

// The least thinning, from `least` on, with which the page's data stays within `target` bytes.
Budget budgetFor(const PageSizes& sizes, size_t target, Budget least = {});
Budget budgetFor(const Report& report, size_t target);

}  // namespace obby::view
