// Checks the values of a recipe.
#pragma once

#include "gen/recipe.h"

namespace obby::gen {

// Error: unknown names, ranges whose ends are in the wrong order, numbers out of bounds.
Status checkRecipe(const Recipe& recipe);

}  // namespace obby::gen
