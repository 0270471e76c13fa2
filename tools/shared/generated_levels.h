// Generated levels for training, new ones in each iteration.
#pragma once

#include <memory>

#include "gen/recipe.h"
#include "train/training_level.h"

namespace obby::tools {

// Generates levels of a recipe, from its lowest difficulty up to the requested one. `seed`: of the
// levels. Errors: those of Generator::make.
Result<std::unique_ptr<train::LevelSource>> generatedLevels(const gen::Recipe& recipe,
                                                            uint64_t seed);

}  // namespace obby::tools
