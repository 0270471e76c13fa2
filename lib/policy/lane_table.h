// The policy's functions that are compiled for each x86-64 level (cmake/ObbyLanes.cmake).
#pragma once

#include "policy/policy.h"

namespace obby::policy {

struct LaneTable {
  policy::Observe observe;
  void (*observeNext)(const Scene&, const sim::World&, const sim::RigidBody*,
                      const sim::NextRegion&, Turns, float*);
  void (*think)(const NetworkView&, const float*, float*);
  sim::Action (*decide)(const Scene&, const NetworkView&, const sim::World&, const sim::RigidBody*,
                        Random*);
  sim::Action (*decideOn)(const Scene&, const NetworkView&, const sim::World&, const float*, Turns,
                          Random*);
};

}  // namespace obby::policy
