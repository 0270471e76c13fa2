// Levels to learn on that are made anew for each turn.
#pragma once

#include <memory>

#include "gen/recipe.h"
#include "train/training_level.h"

namespace obby::tools {

// Levels of a recipe, of its lowest difficulty up to what is asked for. `seed`: of the levels.
// Errors as of Generator::make.
Result<std::unique_ptr<train::LevelSource>> generatedLevels(const gen::Recipe& recipe,
                                                            uint64_t seed);

}  // namespace obby::tools
