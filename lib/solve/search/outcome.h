// What a search found, and what its watcher sees meanwhile.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solve/proof/unreachable.h"
#include "solve/search/search.h"
#include "solve/search/solutions.h"
#include "solve/search/thoroughness.h"

namespace obby::solve {

// Why a search stopped.
enum class Stopped { solved, shown, outOfTime, outOfSteps, interrupted };

// A search at work, as its watcher sees it between rounds.
struct SearchView {
  const Search& search;
  double seconds;
};

struct Watcher {
  // Is this playthrough really a solution? Asked before it is counted.
  std::function<bool(const Playthrough&)> accept;
  // Between rounds, often. Whether to go on: false, and the search is interrupted. May be empty.
  std::function<bool(const SearchView&)> look;
};

struct SearchOutcome {
  Stopped stopped = Stopped::outOfTime;
  std::vector<Playthrough> solutions;  // accepted, distinct, shortest first
  std::vector<RouteTally> routes;      // of the solutions, where several were asked for
  bool diverse = false;                // the solutions differ in route
  std::vector<Playthrough> attempts;   // of those that failed; the closest first
  std::vector<EndCount> ends;
  Statistics statistics;
  Thoroughness thoroughness;
  uint64_t cells = 0;
  uint32_t targetCount = 0;     // waypoints and visits of the query
  uint32_t knownSolutions = 0;  // that an earlier answer had
  uint32_t refused = 0;         // playthroughs that the watcher did not accept
  double seconds = 0;           // wall clock
  double firstSolution = 0;     // seconds to the first accepted solution; 0: none
  std::optional<Cut> cut;       // shown to be unreachable, without a search
  Status device;                // why the machine's device was given up, if it was
};

}  // namespace obby::solve
