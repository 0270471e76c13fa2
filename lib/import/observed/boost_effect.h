// Effects of a touch on the player's speeds and gravity, and their duration.
#pragma once

#include <optional>
#include <vector>

#include "import/observed/probe_effects.h"

namespace obby::importer {

// Is it one of the changes that boosterOf() reads?
bool changesSpeed(const engine::Change& change);

// From the probe's own changes of that kind, in their order; nothing: they change nothing.
std::optional<Booster> boosterOf(const engine::Report& report, const engine::Probe& probe,
                                 const std::vector<const engine::Change*>& changes);

}  // namespace obby::importer
