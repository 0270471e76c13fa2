// Drives Go-Explore round by round until enough solutions are found or the budget is spent.
#pragma once

#include "solve/methods.h"

namespace obby::solve {

SearchOutcome runSearch(const Problem& problem, const Budget& budget,
                        const GoExploreSettings& settings, const Watcher& watcher,
                        const Machine& machine, MakeChooser makeChooser);

}  // namespace obby::solve
