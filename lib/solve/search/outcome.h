// The result of a search, and the interface of its watcher.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solve/proof/unreachable.h"
#include "solve/search/coverage.h"
#include "solve/search/search.h"
#include "solve/search/solutions.h"

namespace obby::solve {

// The reason for which a search stopped.
enum class Stopped { solved, shown, outOfTime, outOfSteps, interrupted };

// A running search, as its watcher sees it between rounds.
struct SearchView {
  const Search& search;
  double seconds;
};

struct Watcher {
  // Returns true if the trajectory is really a solution. Called before it is counted.
  std::function<bool(const Trajectory&)> accept;
  // Called between rounds, often. Returns false to interrupt the search. May be empty.
  std::function<bool(const SearchView&)> look;
};

struct SearchOutcome {
  Stopped stopped = Stopped::outOfTime;
  std::vector<Trajectory> solutions;  // accepted, distinct; the best first
  std::vector<RouteTally> routes;     // routes of the solutions, if several were requested
  bool diverse = false;               // the solutions differ in route
  std::vector<Trajectory> attempts;   // failed trajectories, the closest first
  std::vector<EndCount> ends;
  Statistics statistics;
  Coverage coverage;
  uint64_t cells = 0;
  uint32_t targetCount = 0;     // waypoints and visits of the query
  uint32_t knownSolutions = 0;  // distinct solutions among Problem::known
  uint32_t refused = 0;         // trajectories that the watcher did not accept
  double seconds = 0;           // wall clock
  double firstSolution = 0;     // seconds to the first accepted solution; 0: none
  std::optional<Cut> cut;       // proof that the query is unreachable, without a search
  Status device;                // the error that made the search give up the machine's device
};

}  // namespace obby::solve
