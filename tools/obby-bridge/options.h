// What obby-bridge can be asked for.
#pragma once

#include "bridge/bridge.h"
#include "cli/context.h"
#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec bridgeSpec();

// Error: options that do not go together, or nowhere to keep anything.
Result<bridge::Options> bridgeOptions(const cli::Context& context);

}  // namespace obby::tools
