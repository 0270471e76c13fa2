// Where obby-train has its levels from: made anew for each turn, or read from a stream.
#pragma once

#include <memory>

#include "cli/context.h"
#include "gen/recipe.h"
#include "train/training_level.h"

namespace obby::tools {

// Levels of a recipe, of its lowest difficulty up to what is asked for. `seed`: of the levels.
Result<std::unique_ptr<train::LevelSource>> generatedLevels(const gen::Recipe& recipe,
                                                            uint64_t seed);

// The queries of the context's inputs with their levels, read whole before anything is learned;
// asked for more they begin again. Error: none.
Result<std::unique_ptr<train::LevelSource>> streamedLevels(cli::Context& context);

}  // namespace obby::tools
