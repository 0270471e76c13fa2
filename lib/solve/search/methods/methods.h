// The table of search methods, one row each. A new method is a file with its settings and its
// selector, and a row here.
#pragma once

#include <string>
#include <vector>

#include "solve/search/machine.h"
#include "solve/search/outcome.h"

namespace obby::solve {

using RunMethod = SearchOutcome (*)(const Problem&, const Budget&, const Watcher&, const Machine&);

struct Method {
  const char* name;
  const char* description;
  RunMethod run;
};

const std::vector<Method>& methods();
// Returns null if there is no method of that name.
const Method* findMethod(const std::string& name);

}  // namespace obby::solve
