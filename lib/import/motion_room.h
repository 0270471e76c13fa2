// How many poses and ticks the motions of a level may have together.
#pragma once

#include <string>
#include <vector>

#include "import/roles/role.h"

namespace obby::importer {

// Keys of all motions of a level together: 56 MB, and as much in its record. Their rounds together
// may have as many ticks as a level takes (kMaxLevelRows).
constexpr size_t kMaxLevelKeys = 1000000;

// Seconds of a round, a turn or a wait: the simulator takes no longer ones (level::mostTicks).
constexpr float kLongestMotion = 1200;

// Whether there is room for those of the parts that a player can meet: what of a model is met moves
// as a whole or not at all. What is left still is named.
bool haveRoom(RoleContext& context, const std::vector<PartDraft*>& parts, const Motion& motion,
              const std::string& reason);

// Whether there is room for that of one part. A part that nobody meets yet may still get a role:
// those without room are kept in mind.
bool hasRoom(RoleContext& context, const PartDraft& part, const Motion& motion,
             const std::string& reason);
void takeRoom(RoleContext& context, const PartDraft& part, const Motion& motion);

// Once all roles are known: decoration, which nobody meets, moves as far as the other motions leave
// room for it. Call it once.
void settleMotions(RoleContext& context);

}  // namespace obby::importer
