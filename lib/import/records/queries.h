// Writes one query for each stage of a level.
#pragma once

#include <vector>

#include "import/document/tree.h"
#include "import/draft/draft.h"
#include "io/record.h"

namespace obby::importer {

// The region in which a player has reached a part: its oriented box, 0.5 studs higher and 1 stud
// wider on each side. The simulator tests the vertical segment from the feet to the top of the
// head. That segment is in the middle of a body 2 studs wide, and hovers a little above the floor.
struct GoalBox {
  Pose pose;
  Vec3 size;
};
GoalBox goalBox(const PartDraft& part);

// Returns "stage1" from the start to the first checkpoint, and so on, then from the last checkpoint
// to the goal. Returns nothing if the level has no start or nothing to reach.
std::vector<io::RecordBuilder> stageQueries(const LevelDraft& level, const Tree& tree);

}  // namespace obby::importer
