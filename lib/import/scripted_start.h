// What scripts make of the parts as play starts.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Takes over what scripts do to parts at once and for certain, in the order of the scripts and
// their lines: CanCollide, CanTouch, Anchored, Transparency, sizes, poses; the last write counts,
// and its line is the evidence. What they destroy is left out of context.level, so that the context
// finds parts no more. The place that a script gives to a part before it moves it is left to its
// motion. Call it before strays are culled: scripts bring parts in and out.
void applyScriptedStart(RoleContext& context);

}  // namespace obby::importer
