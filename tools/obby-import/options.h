// The command line of obby-import.
#pragma once

#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec importSpec();

}  // namespace obby::tools
