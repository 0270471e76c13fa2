// Finds when a jump can be pressed so that the segment still succeeds, with all else as recorded.
#pragma once

#include <vector>

#include "solve/report/difficulty/leg.h"
#include "solve/report/difficulty/noise.h"

namespace obby::solve {

constexpr int32_t kMostShift = 20;  // ticks in each direction; beyond them a press is not timed

// Ticks relative to the recorded press. Empty (least > most) if even the recorded press fails.
struct PressWindow {
  int32_t least = 1, most = 0;

  int32_t ticks() const { return most - least + 1; }
  int32_t middle() const { return least > most ? 0 : (least + most) / 2; }
};

// Returns the window of each jump of the segment: the shifts around 0, without a gap, with which
// the segment succeeds. Earlier jumps are pressed in the middle of their windows.
std::vector<PressWindow> pressWindows(const Leg& leg, const NoiseModel& model);

}  // namespace obby::solve
