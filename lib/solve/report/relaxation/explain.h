// Finds out which constraint blocks a query. It searches again with one relaxation at a time, first
// a large one, then the smallest that still gives a solution.
#pragma once

#include <string>
#include <vector>

#include "solve/report/relaxation/change.h"
#include "solve/report/relaxation/failure.h"
#include "solve/search/method.h"

namespace obby::solve {

// A change that makes the query solvable: a search found a trajectory, and the verifier agreed.
struct Relaxation {
  schema::RelaxationKind kind;
  double amount;      // in the relaxation's unit; 0: the limit is removed
  int32_t part;       // the part that changes; -1: none
  int32_t avoid;      // index in the query's avoid list; -1: none
  std::string field;  // field of the query record; empty: the level is changed
  uint64_t steps;     // simulated ticks to the solution
  std::string text;   // for people, without a full stop
};

// Returns the changes that help, small ones first; empty if none helps or there was no time.
// `budget` is for all searches together, and only a fixed number of its steps is used. The result
// depends on `failure`, and on the inputs that determine the result of a search.
std::vector<Relaxation> explain(const Failure& failure, const Method& method, const Budget& budget,
                                const Machine& machine);

}  // namespace obby::solve
