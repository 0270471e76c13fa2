// When a jump can be pressed so that the segment is still done, everything else as recorded.
#pragma once

#include <vector>

#include "solve/report/difficulty/leg.h"
#include "solve/report/difficulty/noise.h"

namespace obby::solve {

constexpr int32_t kMostShift = 20;  // ticks, both ways: beyond, a press is not timed

// Ticks against the recorded press; empty (least > most) where even that one fails.
struct PressWindow {
  int32_t least = 1, most = 0;

  int32_t ticks() const { return most - least + 1; }
  int32_t middle() const { return least > most ? 0 : (least + most) / 2; }
};

// One for each jump of the leg: the row of shifts without a gap around 0 that do the segment. The
// jumps before it are pressed in the middle of theirs.
std::vector<PressWindow> pressWindows(const Leg& leg, const NoiseModel& model);

}  // namespace obby::solve
