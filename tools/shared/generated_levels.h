// Generated levels for training, new ones in each iteration.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gen/recipe.h"
#include "train/training_level.h"

namespace obby::tools {

// Generates levels of a recipe, from its lowest difficulty up to the requested one. `seed`: seed of
// the levels. Errors: those of Generator::make.
Result<std::unique_ptr<train::LevelSource>> generatedLevels(const gen::Recipe& recipe,
                                                            uint64_t seed);

// Returns the number of the style that a level's name states; 0 if it states none.
uint16_t styleNumberOf(const train::TrainingLevel& level);
// Returns the names of the styles, indexed by styleNumberOf(). Name 0 is empty.
std::vector<std::string> styleNames();

}  // namespace obby::tools
