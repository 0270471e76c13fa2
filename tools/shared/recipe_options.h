// The options for levels to generate, shared by all tools that generate levels.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/tool.h"
#include "gen/recipe.h"

namespace obby::tools {

// Returns the rows of --style, --difficulty and --recipe. `group`: their heading in --help.
std::vector<cli::OptionRow> recipeRows(const char* group, const char* defaultDifficulty);

// Returns the text of --recipe's file, or an empty text without one. The file may be a pipe, so it
// is read once.
Result<std::string> recipeText(const cli::Arguments& arguments);

// Returns the recipe of these options; `text`: the contents of --recipe's file. Errors name the
// option or the file.
Result<gen::Recipe> recipeOf(const cli::Arguments& arguments, const std::string& text);
Result<gen::Recipe> recipeOf(const cli::Arguments& arguments);  // reads the file

}  // namespace obby::tools
