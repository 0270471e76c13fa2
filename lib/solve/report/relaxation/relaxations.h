// The table of relaxations: one row for each kind of change that may make a query solvable. A new
// kind is a file with its function, a row here, and an enumerant of the schema's RelaxationKind.
#pragma once

#include <vector>

#include "solve/report/relaxation/change.h"
#include "solve/report/relaxation/failure.h"

namespace obby::solve {

struct RelaxationRow {
  // Returns the changes that are worth trying, most promising first.
  std::vector<Change> (*changes)(const Failure& failure);
};

const std::vector<RelaxationRow>& relaxationRows();

// Returns the changes of all rows, in the order of the table.
std::vector<Change> changesFor(const Failure& failure);

// The functions of the rows. limitChanges() relaxes limits on jumps, time and damage, in total, of
// a segment or up to a waypoint.
std::vector<Change> limitChanges(const Failure& failure);
std::vector<Change> jumpHeightChanges(const Failure& failure);
std::vector<Change> loweredChanges(const Failure& failure);
std::vector<Change> killPartChanges(const Failure& failure);
std::vector<Change> avoidChanges(const Failure& failure);
std::vector<Change> forbiddenChanges(const Failure& failure);

}  // namespace obby::solve
