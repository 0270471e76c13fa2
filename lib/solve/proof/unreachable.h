// Proves without a search that a query is unreachable, by the bound on what a player can reach.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "schema/obby.capnp.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {

// The reason that a query is unreachable: a missing step, too few jumps, or too little time.
struct Cut {
  std::string target;             // for example "the goal" or "waypoint 2 'Bridge'"
  bool mayJump = true;            // the query admits jumps
  std::vector<uint32_t> reached;  // parts
  Missing missing;                // set if `jumps` and `seconds` are 0
  uint32_t jumps = 0;             // lower bound of the jumps to the target
  uint32_t maxJumps = 0;          // jumps that are allowed
  float seconds = 0;              // lower bound of the time to the goal
  float maxSeconds = 0;           // seconds that are allowed
  bool withTricks = false;        // the proof holds for players who use every trick
  uint16_t mayHelp = 0;           // otherwise the tricks that each break the proof
};

// Returns nothing if the query may be solvable. `record` supplies the names of its regions.
std::optional<Cut> cutOf(const Problem& problem, schema::Query::Reader record);

// Returns true if there is a cut. Faster than cutOf(), which also finds what is missing.
bool isCut(const Problem& problem, schema::Query::Reader record);

// Tries the proof with tricks, and fills in the last two fields of the cut. Leaves them unset for
// levels of more than 10,000 colliders, where that takes seconds.
void tryTricks(Cut& cut, Problem problem, schema::Query::Reader record);

}  // namespace obby::solve
