// A trajectory to the goal with every state and the cost up to it, as the base of changed ones.
#pragma once

#include <span>
#include <vector>

#include "solve/improve/cost.h"
#include "solve/model/trajectory.h"

namespace obby::solve {

struct Line {
  std::vector<sim::World> worlds;      // (ticks + 1), the start first
  std::vector<sim::RigidBody> bodies;  // (ticks + 1, level.bodyCount)
  std::vector<sim::Action> actions;    // (ticks): actions[t] leads from state t to state t + 1
  std::vector<CostState> costs;        // (ticks + 1)
  double risk = 0;                     // seconds, for jumps that need an exact press

  uint32_t ticks() const { return uint32_t(actions.size()); }
  double cost() const { return costs.back().cost; }
  std::span<const sim::RigidBody> bodiesAt(uint32_t tick) const {
    const size_t count = bodies.size() / worlds.size();
    return std::span(bodies).subspan(tick * count, count);
  }
};

// Plays the actions from the problem's start until the trajectory ends or they do.
Line playLine(const Problem& problem, std::span<const sim::Action> actions, const CostMeter& meter);

// Returns the trajectory of a line.
Trajectory trajectoryOf(const Line& line);

std::vector<sim::Action> actionsOf(const Trajectory& trajectory);

}  // namespace obby::solve
