#include "solve/report/relaxation/relaxations.h"

#include <iterator>

namespace obby::solve {

const std::vector<RelaxationRow>& relaxationRows() {
  static const std::vector<RelaxationRow> table = {
      {limitChanges},    {jumpHeightChanges}, {loweredChanges},
      {killPartChanges}, {avoidChanges},      {forbiddenChanges},
  };
  return table;
}

std::vector<Change> changesFor(const Failure& failure) {
  std::vector<Change> all;
  for (const RelaxationRow& row : relaxationRows()) {
    std::vector<Change> some = row.changes(failure);
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace obby::solve
