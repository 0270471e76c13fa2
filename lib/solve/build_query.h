// Query records made from the command line, or from what the level says about itself.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::solve {

// A query in selectors (select_parts.h). Empty start: the level's first spawn. Empty goal: the
// level's goal part, else its last checkpoint.
struct QuickQuery {
  std::string start, goal;
  std::vector<std::string> waypoints;  // in order
  std::vector<std::string> avoid;      // a #tag may name several parts: all are avoided
  int32_t maxJumps = -1;
  float timeLimit = 0;  // seconds
};

// The query record; its id is `id`. Error: a selector that names no part or several, a level
// without a spawn or goal.
Result<io::Record> buildQuery(schema::Level::Reader level, const QuickQuery& quick,
                              const std::string& id);

}  // namespace obby::solve
