// The manual page of a tool, made from its option table.
#pragma once

#include <string>
#include <vector>

#include "cli/tool.h"

namespace obby::cli {

// Returns the page in roff with the macros of man(7).
std::string manualPage(const ToolSpec& spec, const std::vector<OptionRow>& rows);

}  // namespace obby::cli
