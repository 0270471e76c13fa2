// The options that say what levels to make, for all tools that make some.
#pragma once

#include <vector>

#include "cli/arguments.h"
#include "cli/tool.h"
#include "gen/recipe.h"

namespace obby::tools {

// --style, --difficulty, --recipe. `group`: the heading that --help lists them under.
std::vector<cli::OptionRow> recipeRows(const char* group);

// What they ask for. Errors name the option or the file.
Result<gen::Recipe> recipeOf(const cli::Arguments& arguments);

}  // namespace obby::tools
