// obby-solve's command line.
#pragma once

#include <vector>

#include "cli/context.h"
#include "cli/tool.h"
#include "sim/backend.h"
#include "solve/filter.h"

namespace obby::tools {

cli::ToolSpec solveSpec();
// Returns the options that define a query on the command line.
std::vector<cli::OptionRow> queryRows();
Result<solve::FilterOptions> filterOptions(cli::Context& context);
// Returns the backend for rollouts; --backend auto is the CPU.
Result<sim::Backend> searchBackend(const cli::Context& context);

}  // namespace obby::tools
