// Progress of the player as scripts keep it: stages, teams, the place to come back to, wins.
#pragma once

#include <initializer_list>

#include "import/draft.h"
#include "import/observed/probe_effects.h"

namespace obby::importer {

// Adds what a note about the player says of its progress. False: the note is about something else.
bool takeProgress(ProbeEffects& effects, const engine::Change& note, InstanceId touched);

// If a number of a name that says nothing is that of the part itself, it is the part's stage.
void takeOwnNumber(ProbeEffects& effects, std::initializer_list<int> numbersOfPart);

// A player who died after the touch, and came back to the part instead of the spawn. A part that
// kills and brings the player on is a portal to where it comes back.
void takeComeback(ProbeEffects& effects, const engine::Report& report, const engine::Probe& probe,
                  const PartDraft& part);

}  // namespace obby::importer
