// The table of knobs: one row for each kind of change that may make a query solvable. A new knob is
// a file with its function and a row here, and an enumerant of the schema's Knob.
#pragma once

#include <vector>

#include "solve/report/relaxation/change.h"
#include "solve/report/relaxation/failure.h"

namespace obby::solve {

struct Knob {
  // What is worth trying, most promising first; the failure says where to look.
  std::vector<Change> (*changes)(const Failure& failure);
};

const std::vector<Knob>& knobs();

// The changes of all knobs, in the order of the table.
std::vector<Change> changesFor(const Failure& failure);

// The rows. Limits of the query: jumps, time and damage, in all, of a segment or up to a waypoint.
std::vector<Change> limitChanges(const Failure& failure);
std::vector<Change> jumpHeightChanges(const Failure& failure);
std::vector<Change> loweredChanges(const Failure& failure);
std::vector<Change> killPartChanges(const Failure& failure);
std::vector<Change> avoidChanges(const Failure& failure);
std::vector<Change> forbiddenChanges(const Failure& failure);

}  // namespace obby::solve
