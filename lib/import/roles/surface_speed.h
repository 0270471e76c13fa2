// An anchored part with a velocity moves what stands on it: sideways it is a conveyor, upward a
// trampoline. The two roles share this evidence.
#pragma once

#include <string>

#include "import/draft/draft.h"

namespace obby::importer {

class RoleContext;

constexpr float kLeastSpeed = 0.5f;  // studs/s; lower speeds are noise

// Returns true if the velocity throws rather than carries: mostly upward.
bool isUpward(Vec3 velocity);

// Gives the part one of the two roles, unless it has that role already or the speed is noise.
void giveConveyor(PartDraft& part, Conveyor conveyor, std::string reason, bool guessed);
void giveJumpPad(PartDraft& part, JumpPad pad, std::string reason, bool guessed);

}  // namespace obby::importer
