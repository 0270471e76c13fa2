// Compares a later touch of a part with the first one.
#pragma once

#include <string>

#include "import/document/tree.h"
#include "import/observed/probe_effects.h"

namespace obby::importer {

// Returns the effects of `now` that `before` lacks.
ProbeEffects addedIn(const ProbeEffects& before, const ProbeEffects& now);
// Returns the effects of `before` that end by themselves and that `now` lacks.
ProbeEffects endedIn(const ProbeEffects& before, const ProbeEffects& now);
// Returns the condition of the later touch: "once 'Lever' has been touched".
std::string whenOf(const Tree& tree, const engine::Revisit& revisit);

}  // namespace obby::importer
