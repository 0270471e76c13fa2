// What obby-import is to its user.
#pragma once

#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec importSpec();

}  // namespace obby::tools
