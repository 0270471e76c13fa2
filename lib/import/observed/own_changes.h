// Finds the changes that a probe causes. Others occur without it, or with any walk.
#pragma once

#include <vector>

#include "engine/report.h"

namespace obby::importer {

// Returns the probed moves that a player makes before it reaches a part: a walk if scripts read
// MoveDirection, and the stay away from all parts. The part does not cause their effects.
std::vector<const engine::Probe*> movesBefore(const engine::Report& report,
                                              const engine::Probe& probe);

// Returns the probe's changes without those of the undisturbed run at the same time, and without
// those of movesBefore().
std::vector<const engine::Change*> changesByTouch(const engine::Report& report,
                                                  const engine::Probe& probe);

}  // namespace obby::importer
