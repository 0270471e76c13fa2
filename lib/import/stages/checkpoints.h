// Finds start, checkpoints and end of a level in the order of play.
#pragma once

#include <optional>

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Fills level.spawns: stage 0 is the start, then the checkpoints. Sets part.checkpoint to 1, 2, ...
// `arrived` is the feet of a new player after the scripts ran, or nullopt if unknown.
void orderStages(const Tree& tree, LevelDraft& level, const std::optional<Vec3>& arrived);

// Returns the feet of a player who appears on the part, and the yaw of the part's front.
SpawnDraft spawnOn(const Tree& tree, const PartDraft& part, int index, int stage);

}  // namespace obby::importer
