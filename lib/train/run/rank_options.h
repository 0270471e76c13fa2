// Ranks must be started with the same options. A rank with another option would fall out of step
// with the others, or ignore what it was told.
#pragma once

#include <string>
#include <vector>

#include "train/ranks.h"

namespace obby::train {

// `options`: how this rank was started, each as it reads after "started": "with --seed 3". The list
// has the same length and order on every rank, up to the first that differs. Returns the error of
// the first rank that differs from rank 0, about its first such option, with both.
Status sameOnAllRanks(const std::vector<std::string>& options, Ranks& ranks);

// Before it exchanges anything else, each rank calls one of these two, once. A rank that is going
// to run states its version and options.
Status sameOptions(std::vector<std::string> options, Ranks& ranks);
// A rank that is not going to run, because its command line was `refused` or only asked for help.
// Success: no rank is going to run.
Status notRunning(bool refused, Ranks& ranks);

}  // namespace obby::train
