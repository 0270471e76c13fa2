// Queries that nobody can solve, shown without a search by the bound on what a player can reach.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "schema/obby.capnp.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {

// Why a query is unreachable. One of the three: a step that is missing, too few jumps, too little
// time.
struct Cut {
  std::string target;             // "the goal", "waypoint 2 'Bridge'"
  bool mayJump = true;            // the query admits jumps
  std::vector<uint32_t> reached;  // parts
  Missing missing;                // where `jumps` and `seconds` are 0
  uint32_t jumps = 0;             // that the way to the target takes at least
  uint32_t mostJumps = 0;         // that are allowed
  float seconds = 0;              // that it takes at least
  float mostSeconds = 0;          // that are allowed
  bool withTricks = false;        // shown for players who use every trick
  uint16_t mayHelp = 0;           // if not: tricks with which, each by itself, it is not shown
};

// Nothing: the query may be solvable. `record`: for the names of its regions.
std::optional<Cut> cutOf(const Problem& problem, schema::Query::Reader record);

// Is there a cut? Sooner than finding what is missing.
bool isCut(const Problem& problem, schema::Query::Reader record);

// Fills in the cut's last two fields: asks again with tricks. Leaves them for levels of more than
// 10,000 colliders, where that takes seconds.
void tryTricks(Cut& cut, Problem problem, schema::Query::Reader record);

}  // namespace obby::solve
