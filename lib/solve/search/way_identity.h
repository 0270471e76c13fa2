// When two ways to the goal count as one.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/model/playthrough.h"
#include "solve/model/problem.h"

namespace obby::solve {

constexpr float kDistinct = 4;  // studs

struct Way {
  Playthrough playthrough;
  std::vector<int32_t> route;  // directRouteOf(); empty until somebody asks
  uint64_t found = 1;          // ways that count as this one, with it
};

struct WayIdentity {
  // Works out what `same` looks at; null: the playthrough is enough.
  void (*prepare)(const Problem& problem, Way& way);
  bool (*same)(const Way& a, const Way& b);
  // Is a second way that is the same a solution in its own right, or a copy of the first?
  bool counts;
};

// Nowhere are they farther than kDistinct apart.
const WayIdentity& byPath();
// The same parts carry the player, in the same order, trivial detours aside and but for at most one
// part more or less: who touches a second part in passing has taken no other route.
const WayIdentity& byRoute();

// Is some point of either path farther than `distance` from every point of the other?
bool pathsDiffer(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance);

// Of the way's playthrough; costs a replay the first time.
void noteRoute(const Problem& problem, Way& way);

}  // namespace obby::solve
