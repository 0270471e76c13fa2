// obby-gen's command line.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"
#include "gen/recipe.h"

namespace obby::tools {

cli::ToolSpec genSpec();
// Returns the text of --list: all styles, or those of the recipe with their parameters.
std::string listOfStyles(const gen::Recipe& recipe);

}  // namespace obby::tools
