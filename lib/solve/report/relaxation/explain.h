// Which constraint blocks a query: searches again with one knob turned at a time, far first, then
// as little as still gives a solution.
#pragma once

#include <string>
#include <vector>

#include "solve/report/relaxation/change.h"
#include "solve/report/relaxation/failure.h"
#include "solve/search/methods/methods.h"

namespace obby::solve {

// One change that makes the query solvable: a playthrough of the changed query was found, and the
// verifier agreed.
struct Relaxation {
  schema::Knob knob;
  double amount;      // in the knob's unit; 0: what it limits is gone
  int32_t part;       // -1: none
  int32_t avoid;      // of the query's avoid list; -1: none
  std::string field;  // of the query record; empty: the level is changed
  uint64_t steps;     // simulated ticks to the solution
  std::string text;   // for people, without a full stop
};

// Small changes first; empty if nothing that was tried helps, or there was no time. `budget` is for
// all searches together; of its steps no more than a fixed number are used. The outcome depends on
// what a search's does, and on the failure.
std::vector<Relaxation> explain(const Failure& failure, const Method& method, const Budget& budget,
                                const Machine& machine);

}  // namespace obby::solve
