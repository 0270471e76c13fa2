// The result of a run as one line for users.
#pragma once

#include <string>

#include "solve/filter.h"

namespace obby::tools {

struct RunOutcome {
  solve::FilterCounts counts;
  double seconds = 0;

  // Returns true if nothing was answered, checked or filtered.
  bool isEmpty() const;
};

// Returns a text such as "3 solved, 1 unreachable, 0 unknown in 2.1 s".
std::string summary(solve::Task task, const RunOutcome& outcome);

}  // namespace obby::tools
