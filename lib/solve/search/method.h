// A search method: its name, and the function that runs it.
#pragma once

#include "solve/search/machine.h"
#include "solve/search/outcome.h"

namespace obby::solve {

using RunMethod = SearchOutcome (*)(const Problem&, const Budget&, const Watcher&, const Machine&);

struct Method {
  const char* name;
  const char* description;
  RunMethod run;
};

}  // namespace obby::solve
