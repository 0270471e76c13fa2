// Ranks have to be started alike: what one is told otherwise would set it out of step with the
// rest, or be passed over without a word.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.h"
#include "train/ranks.h"

namespace obby::tools {

// `said`: what was said to this rank, each behind "started": "with --seed 3". As many on
// every rank, in the same order, unless an earlier one differs. Error: of the first rank that was
// told something else than rank 0, with both; the first such of all.
Status sameOnAll(const std::vector<std::string>& said, train::Ranks& ranks);

// Each rank calls one of these two, once, before it exchanges anything else with the others.
// Of one that has options to go by: the same as rank 0, but for what each may be told for itself.
Status sameOptions(const cli::Arguments& arguments, train::Ranks& ranks);
// Of one that has none, for its command line was `refused`, or asked for --help or the like.
// Success: neither has any other.
Status noOptions(bool refused, train::Ranks& ranks);

}  // namespace obby::tools
