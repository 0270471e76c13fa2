// Decides the effects of movers, both constraints and the older body movers. They push at a
// velocity, pull to a place, follow a moving part, or turn.
#pragma once

#include <map>

#include "import/roles/driven.h"

namespace obby::importer {

// The number of constraints that act on the position of a part or its joined parts, by part.
// Constraints that only turn them do not count.
using Pulls = std::map<InstanceId, int>;
Pulls pullsOf(RoleContext& context, const ConstraintSettings& settings);

// Gives a motion to the part of an enabled mover, or holds the part in place. If the file does not
// state where the motion ends, the part is held, and the level notes it. Returns false without
// effect if the mover is too weak, is of another class, or drives no unanchored part.
bool fromMover(RoleContext& context, const ConstraintSettings& settings, const Pulls& pulls,
               InstanceId id);

// Notes parts that another mover turns, and that this mover would push away or back and forth.
void noteTurning(RoleContext& context, const ConstraintSettings& settings, InstanceId id);

// Returns true for a class that gives a part a velocity. Process the turners of a part first.
bool isPusher(const std::string& className);

// Returns true for a class that holds a part in place when no script moves it.
bool isHolder(const std::string& className);

}  // namespace obby::importer
