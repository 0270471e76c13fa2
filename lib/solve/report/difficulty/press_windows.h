// Finds when a jump can be pressed so that the segment still succeeds, with all else as recorded.
#pragma once

#include <vector>

#include "solve/report/difficulty/last_segments.h"
#include "solve/report/difficulty/noise.h"

namespace obby::solve {

constexpr int32_t kMaxShift = 20;  // ticks each way; a press with a wider window need not be timed

// Ticks relative to the recorded press. Empty (min > max) if even the recorded press fails.
struct PressWindow {
  int32_t min = 1, max = 0;

  int32_t ticks() const { return max - min + 1; }
  int32_t middle() const { return min > max ? 0 : (min + max) / 2; }
};

// Returns the window of each jump of the segment: the shifts around 0, without a gap, with which
// the segment succeeds. Earlier jumps are pressed in the middle of their windows.
std::vector<PressWindow> pressWindows(const LastSegments& rest, const NoiseModel& model);

}  // namespace obby::solve
