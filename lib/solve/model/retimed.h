// The same keys at another frame rate: held by time, each change rounded up to the player's next
// tick, for a controller reads the keys once a frame.
#pragma once

#include <cstdint>

#include "solve/model/problem.h"

namespace obby::solve {

// Keys that fall between two ticks are lost. The last keys are held to the end.
KnownWay retimed(const KnownWay& way, uint32_t from, uint32_t to);

}  // namespace obby::solve
