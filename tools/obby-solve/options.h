// obby-solve's command line.
#pragma once

#include <vector>

#include "cli/context.h"
#include "cli/tool.h"
#include "sim/backend.h"
#include "solve/filter.h"

namespace obby::tools {

cli::ToolSpec solveSpec();
// Those of its options that ask on the command line.
std::vector<cli::OptionRow> queryRows();
Result<solve::FilterOptions> filterOptions(cli::Context& context);
// Where rollouts run; --backend auto is the CPU.
Result<sim::Backend> searchBackend(const cli::Context& context);

}  // namespace obby::tools
