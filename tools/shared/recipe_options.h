// The options that say what levels to make, for all tools that make some.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/tool.h"
#include "gen/recipe.h"

namespace obby::tools {

// --style, --difficulty, --recipe. `group`: the heading that --help lists them under.
std::vector<cli::OptionRow> recipeRows(const char* group, const char* defaultDifficulty);

// What is in the file of --recipe, which may be a pipe and is read once; nothing without one.
Result<std::string> recipeText(const cli::Arguments& arguments);

// What they ask for; `text`: of the file. Errors name the option or the file.
Result<gen::Recipe> recipeOf(const cli::Arguments& arguments, const std::string& text);
Result<gen::Recipe> recipeOf(const cli::Arguments& arguments);  // reads the file

}  // namespace obby::tools
