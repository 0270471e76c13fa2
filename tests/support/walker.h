// Random play that holds each action for 10 to 50 ticks.
#pragma once

#include "base/random.h"
#include "sim/world.h"

namespace obby::support {

struct Walker {
  Random random;
  sim::Action action;
  uint32_t left = 0;

  sim::Action next() {
    if (left-- == 0) {
      left = 10 + random.below(40);
      action = {Turns(random.next()), random.below(10) != 0, random.below(20) < 8};
    }
    return action;
  }
};

}  // namespace obby::support
