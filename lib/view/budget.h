// The size limits of a page. Browsers get slow beyond some 20 MB.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "view/report.h"

namespace obby::view {

constexpr size_t kPageTarget = 20u << 20;  // bytes; beyond it data is thinned out
constexpr size_t kPageLimit = 200u << 20;  // bytes; larger pages are not written

struct Budget {
  uint32_t attemptStride = 1;      // every n-th tick of failed attempts is kept; solutions keep all
  uint32_t trackStride = 1;        // every n-th tick of moving parts is kept
  uint32_t attemptsOneOf = 1;      // every n-th failed attempt is kept
  std::vector<std::string> notes;  // sentences for users about what was thinned
};

// Returns the ticks of each level's clock that the page must cover.
std::vector<uint32_t> ticksShown(const Report& report);
// Returns the ticks for a level without trajectories.
uint32_t minTicksShown(const LevelEntry& level);

// Estimated sizes of a page's data without thinning, bytes.
struct PageSizes {
  size_t fixed = 0, attempts = 0, tracks = 0;
  // Data of attempts that no stride thins: dynamic bodies, actions, numbers.
  size_t whole = 0;
  bool longMotion = false;  // some part moves for longer than a page covers

  // `ticks`: motion that the page covers.
  void add(const LevelEntry& level, uint32_t ticks);
  void add(const QueryEntry& query);
};

// Returns the least thinning, at least `min`, that keeps the page's data within `target` bytes.
Budget budgetFor(const PageSizes& sizes, size_t target, Budget min = {});
Budget budgetFor(const Report& report, size_t target);

}  // namespace obby::view
