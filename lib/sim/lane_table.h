// The simulator's functions that are compiled for each x86-64 level (cmake/ObbyLanes.cmake).
#pragma once

#include "sim/tick.h"
#include "sim/wide_tick.h"

namespace obby::sim {

struct LaneTable {
  decltype(&sim::tick<true>) tick;
  decltype(&sim::tick<false>) tickWithoutBodies;
  decltype(&sim::tickAll) tickAll;
};

}  // namespace obby::sim
