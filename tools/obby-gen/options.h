// obby-gen's command line.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec genSpec();
// What --list prints.
std::string listOfStyles();

}  // namespace obby::tools
