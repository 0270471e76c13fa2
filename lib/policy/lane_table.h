// The policy's functions that are compiled for each x86-64 level (cmake/ObbyLanes.cmake).
#pragma once

#include "policy/policy.h"

namespace obby::policy {

struct LaneTable {
  Observe observe;
  void (*observeNext)(const Scene&, const sim::World&, const sim::LooseBody*,
                      const sim::NextRegion&, Turns, float*);
  decltype(&think) think;
  decltype(&decide) decide;
  decltype(&decideOn) decideOn;
};

}  // namespace obby::policy
