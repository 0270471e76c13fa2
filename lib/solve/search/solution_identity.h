// Decides when two trajectories to the goal count as the same solution.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/model/problem.h"
#include "solve/model/trajectory.h"

namespace obby::solve {

constexpr float kDistinct = 4;  // studs

struct Solution {
  Trajectory trajectory;
  std::vector<int32_t> route;  // directRouteOf(); empty until noteRoute() is called
  uint64_t found = 1;          // trajectories that count as this one, including itself
};

struct SolutionIdentity {
  // Prepares the data that `same` compares; null if the trajectory is enough.
  void (*prepare)(const Problem& problem, Solution& solution);
  bool (*same)(const Solution& a, const Solution& b);
  // True if a second trajectory that is the same counts as another solution, not as a copy.
  bool counts;
};

// Trajectories are the same if their paths are nowhere farther than kDistinct apart.
const SolutionIdentity& byPath();
// Trajectories are the same if the same parts carry the player in the same order, apart from
// trivial detours. One extra part is allowed: touching a second part in passing makes no new route.
const SolutionIdentity& byRoute();

// Returns true if a point of either path is farther than `distance` from every point of the other.
bool pathsDiffer(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance);

// Fills in the route of the trajectory. The first call costs a replay.
void noteRoute(const Problem& problem, Solution& solution);

}  // namespace obby::solve
