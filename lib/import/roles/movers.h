// What movers do to parts, be they constraints or the older body movers: they push at a velocity,
// pull to a place, follow what moves, or turn.
#pragma once

#include <map>

#include "import/roles/driven.h"

namespace obby::importer {

// How many constraints act on where a part and what is joined to it are, by part; those that only
// turn them do not count.
using Pulls = std::map<InstanceId, int>;
Pulls pullsOf(RoleContext& context, const ConstraintSettings& settings);

// Gives a motion to what an enabled mover moves, or holds it where it is. Where the file does not
// tell the way, it is held, and the level names it. False if it drives nothing that is loose, is
// too weak, or is of another class; then nothing is changed.
bool fromMover(RoleContext& context, const ConstraintSettings& settings, const Pulls& pulls,
               InstanceId id);

// Names what a mover that drives nothing would push away or to and fro, if another one turns it.
void noteTurning(RoleContext& context, const ConstraintSettings& settings, InstanceId id);

// A class that gives a part a velocity. Turners of a part come before it.
bool isPusher(const std::string& className);

// A class that holds a part in place where nothing steps it.
bool isHolder(const std::string& className);

}  // namespace obby::importer
