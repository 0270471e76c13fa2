// What a part does at a later touch and did not at the first one, and the other way round.
#pragma once

#include <string>

#include "import/observed/probe_effects.h"
#include "import/tree.h"

namespace obby::importer {

// The effects of `now` that `before` lacks.
ProbeEffects addedIn(const ProbeEffects& before, const ProbeEffects& now);
// The effects of `before` that end by themselves and that `now` lacks.
ProbeEffects endedIn(const ProbeEffects& before, const ProbeEffects& now);
// When the later touch differs: "once 'Lever' has been touched".
std::string whenOf(const Tree& tree, const engine::Revisit& revisit);

}  // namespace obby::importer
