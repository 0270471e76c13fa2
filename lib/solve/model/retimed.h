// Converts keys to another frame rate. They are held by time, and each change is rounded up to the
// player's next tick, since a controller reads the keys once per frame.
#pragma once

#include <cstdint>

#include "solve/model/problem.h"

namespace obby::solve {

// Keys that fall between two ticks are lost. The last keys are held to the end.
ActionRuns retimed(const ActionRuns& runs, uint32_t from, uint32_t to);

}  // namespace obby::solve
