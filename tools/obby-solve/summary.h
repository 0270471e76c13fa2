// What a run came to, in a line for people.
#pragma once

#include <string>

#include "solve/filter.h"

namespace obby::tools {

struct RunOutcome {
  solve::FilterCounts counts;
  double seconds = 0;

  // Nothing was answered, checked or filtered.
  bool isEmpty() const;
};

// "3 solved, 1 unreachable, 0 unknown in 2.1 s"
std::string summary(solve::Task task, const RunOutcome& outcome);

}  // namespace obby::tools
