// --watch: answers again whenever an input file changes, each time from what the last answer found.
#pragma once

#include "cli/context.h"
#include "options.h"

namespace obby::tools {

// One run over the inputs; returns what it came to, in words. `options` keeps what the next run can
// begin with.
using SolveOnce = std::function<Result<std::string>(solve::FilterOptions& options,
                                                    const std::atomic<bool>& stop)>;

// Until the process is told to end; tells after each run what it came to and which verdicts
// changed. Error: an input that is not a file, or that is the output too; an output that nobody
// reads any more.
Status watchInputs(cli::Context& context, solve::FilterOptions& options, const SolveOnce& solve);

}  // namespace obby::tools
