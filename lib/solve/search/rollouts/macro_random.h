// Random exploration as in the Go-Explore paper: an action is held, and released with a probability
// of 1/20 at each tick. The length is drawn at once.
#pragma once

#include "base/random.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

struct RandomMacro {
  sim::Action action;
  uint32_t ticks;
};

// Draws the length of a run that goes on with probability 95 %: mean 20, at most 120.
OBBY_DEVICE uint32_t drawHoldTicks(Random& random) {
  const float u = random.unit();
  float rest = 0.95f;
  uint32_t ticks = 1;
  while (rest > u && ticks < 120) {
    rest *= 0.95f;
    ++ticks;
  }
  return ticks;
}

// Draws one of 16 headings or standing, with or without a jump.
OBBY_DEVICE RandomMacro drawRandomMacro(Random& random) {
  const uint32_t draw = random.below(34);
  const uint32_t direction = draw >> 1;
  const bool walk = direction < 16;
  return {{walk ? Turns(direction << 12) : Turns(0), walk, (draw & 1) != 0}, drawHoldTicks(random)};
}

}  // namespace obby::solve
