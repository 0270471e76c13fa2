// Completion scripts, made from the option table.
#pragma once

#include <string>
#include <vector>

#include "cli/tool.h"

namespace obby::cli {

// `shell` is bash, zsh or fish.
std::string completionScript(const ToolSpec& spec, const std::vector<OptionRow>& all,
                             const std::string& shell);

}  // namespace obby::cli
