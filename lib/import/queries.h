// The queries that a level asks by itself: one for each stage.
#pragma once

#include <vector>

#include "import/draft.h"
#include "import/tree.h"
#include "io/record.h"

namespace obby::importer {

// Where a player counts as having reached a part: its oriented box, 0.5 studs higher and 1 stud
// wider on each side. The simulator counts a player as inside a region when the vertical segment
// from the feet to the top of the head meets the box; that segment is in the middle of a body 2
// studs wide, and hovers a little above what it stands on.
struct GoalBox {
  Pose pose;
  Vec3 size;
};
GoalBox goalBox(const PartDraft& part);

// "stage1" from the start to the first checkpoint, and so on, then from the last checkpoint to the
// goal. Empty if the level has no start, or nothing to reach.
std::vector<io::RecordBuilder> stageQueries(const LevelDraft& level, const Tree& tree);

}  // namespace obby::importer
