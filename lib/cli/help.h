// What --help, --version and a bare call on a terminal print.
#pragma once

#include <string>
#include <vector>

#include "cli/tool.h"

namespace obby::cli {

// "obby-solve 0.1.0"
std::string versionLine(const ToolSpec& spec);

// Name, examples, usage, options by group, notes; 80 columns. Lines that begin with "  $ " are
// examples and nothing else is: tests run them.
std::string helpText(const ToolSpec& spec, const std::vector<OptionRow>& rows);

// A few lines for those who gave no input.
std::string shortHelp(const ToolSpec& spec);

}  // namespace obby::cli
