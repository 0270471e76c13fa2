// The command line of obby-bridge.
#pragma once

#include "bridge/bridge.h"
#include "cli/context.h"
#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec bridgeSpec();

// Error: incompatible options, or no directory for saved data.
Result<bridge::Options> bridgeOptions(const cli::Context& context);

}  // namespace obby::tools
