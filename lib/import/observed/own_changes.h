// Finds the changes that a probe causes. Other changes also occur without the probe, or on any
// walk.
#pragma once

#include <vector>

#include "engine/report.h"

namespace obby::importer {

// Returns the probed moves that a player makes before it reaches a part: a walk if scripts read
// MoveDirection, and a stay away from all parts. The part does not cause the effects of these
// moves.
std::vector<const engine::Probe*> movesBefore(const engine::Report& report,
                                              const engine::Probe& probe);

// Returns the probe's changes without those of the undisturbed run at the same time, and without
// those of movesBefore().
std::vector<const engine::Change*> changesByTouch(const engine::Report& report,
                                                  const engine::Probe& probe);

}  // namespace obby::importer
