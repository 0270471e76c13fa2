// A trajectory found by the search, as plain actions.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/simulator.h"

namespace obby::solve {

constexpr uint32_t kPathStep = 6;  // ticks between the points of a path

struct Trajectory {
  std::vector<sim::ActionRun> actions;
  std::vector<Vec3> path;           // feet every kPathStep ticks, the start first
  std::vector<uint32_t> jumpTicks;  // ticks since the start
  sim::World end;
  std::vector<sim::RigidBody> endBodies;
  uint32_t ticks = 0;
};

}  // namespace obby::solve
