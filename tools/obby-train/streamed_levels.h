// Levels to learn on that come from a stream.
#pragma once

#include <memory>

#include "cli/context.h"
#include "train/training_level.h"

namespace obby::tools {

// The queries of the context's inputs with their levels, read whole before anything is learned;
// asked for more they begin again. Error: none.
Result<std::unique_ptr<train::LevelSource>> streamedLevels(cli::Context& context);

}  // namespace obby::tools
