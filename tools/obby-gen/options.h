// obby-gen's command line.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"
#include "gen/recipe.h"

namespace obby::tools {

cli::ToolSpec genSpec();
// The recipe of --recipe, with what the other options say in place of its own.
Result<gen::Recipe> recipeOf(const cli::Arguments& arguments);
// What --list prints.
std::string listOfStyles();

}  // namespace obby::tools
