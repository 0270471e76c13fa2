// Finds the effects of a touch on the player's speeds and gravity, and their duration.
#pragma once

#include <optional>
#include <vector>

#include "import/observed/probe_effects.h"

namespace obby::importer {

// Returns true if boosterOf() reads the change.
bool changesSpeed(const engine::Change& change);

// Returns the booster that the probe's own changes of speed make, in order of time. Returns nullopt
// if they change nothing.
std::optional<Booster> boosterOf(const engine::Report& report, const engine::Probe& probe,
                                 const std::vector<const engine::Change*>& changes);

}  // namespace obby::importer
