// Start, checkpoints and end of a level in the order of play.
#pragma once

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Stage of a checkpoint that nobody numbered; only until orderStages has run.
constexpr int kUnnumbered = -1;

// The number that a checkpoint states: an attribute or value object of the tagged instance or of
// its touched part, else a number in their names, else in the name of a folder above that is of
// stages or checkpoints ("Stages", "Stage 3 Lava") or nothing but a number.
int stageNumber(const Tree& tree, InstanceId id, InstanceId part);

// Fills level.spawns: stage 0 is the start, then the checkpoints; sets part.checkpoint to 1, 2, ...
// SpawnLocations that are no start become checkpoints. Without any stated goal the last checkpoint
// is the goal (guessed); of several guessed goals one stays. What could not be decided is noted.
void orderStages(const Tree& tree, LevelDraft& level);

// Where the feet of a player stand who appears on the part, and the yaw of its front.
SpawnDraft spawnOn(const Tree& tree, const PartDraft& part, int index, int stage);

}  // namespace obby::importer
