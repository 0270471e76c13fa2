// Reads the player's progress as scripts store it: stages, teams, respawn places, wins.
#pragma once

#include <initializer_list>

#include "import/draft/draft.h"
#include "import/observed/probe_effects.h"

namespace obby::importer {

// Adds the progress that a note about the player shows. Returns false if the note is about
// something else.
bool takeProgress(ProbeEffects& effects, const engine::Change& note, InstanceId touched);

// Takes a number with an uninformative name as the part's stage if it equals the part's own number.
void takeOwnNumber(ProbeEffects& effects, std::initializer_list<int> numbersOfPart);

// Reads a respawn: the player died after the touch and came back at the part instead of the spawn.
// A part that kills and whose player respawns farther on is a portal to the respawn position.
void takeComeback(ProbeEffects& effects, const engine::Report& report, const engine::Probe& probe,
                  const PartDraft& part);

}  // namespace obby::importer
