// Drives a search round by round until enough solutions are found or the budget is spent.
#pragma once

#include <functional>
#include <memory>

#include "solve/search/machine.h"
#include "solve/search/outcome.h"

namespace obby::solve {

using MakeSearch = std::function<std::unique_ptr<Search>()>;

SearchOutcome runSearch(const Problem& problem, const Budget& budget, const Watcher& watcher,
                        const MakeSearch& makeSearch);

}  // namespace obby::solve
