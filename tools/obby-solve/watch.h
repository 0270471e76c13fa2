// --watch: answers again whenever an input file changes, starting from the last run's results.
#pragma once

#include "cli/context.h"
#include "options.h"

namespace obby::tools {

// Runs once over the inputs and returns the outcome as text. `options` keeps the results that the
// next run can start with.
using SolveOnce = std::function<Result<std::string>(solve::FilterOptions& options,
                                                    const std::atomic<bool>& stop)>;

// Runs until the process is asked to end. After each run it reports the outcome and the changed
// verdicts. Errors: an input that is not a file or is also the output, or an output without a
// reader.
Status watchInputs(cli::Context& context, solve::FilterOptions& options, const SolveOnce& solve);

}  // namespace obby::tools
