// Ranks must be started with the same options. A rank with another option would fall out of step
// with the others, or ignore its own option.
#pragma once

#include <string>
#include <vector>

#include "train/ranks.h"

namespace obby::train {

// `options`: how this rank was started, each worded to follow "started", such as "with --seed 3".
// The list has the same length and order on every rank, up to the first that differs. Returns the
// error of the first rank that differs from rank 0. It names both values of that rank's first
// differing option.
Status sameOnAllRanks(const std::vector<std::string>& options, Ranks& ranks);

// Call one of these two once, before any other exchange. sameOptions() is for a rank that will run:
// it states its version and options.
Status sameOptions(std::vector<std::string> options, Ranks& ranks);
// notRunning() is for a rank that will not run, because its command line was `refused` or only
// asked for help. Returns success if no rank will run.
Status notRunning(bool refused, Ranks& ranks);

}  // namespace obby::train
