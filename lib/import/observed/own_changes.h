// The changes in a probe that are its own: the rest came by itself or with any walk.
#pragma once

#include <vector>

#include "engine/report.h"

namespace obby::importer {

// The moves that a player makes on the way to a part: what scripts do about them is not the part's
// doing. A walk, where scripts read MoveDirection; and to be away from all parts.
std::vector<const engine::Probe*> movesBefore(const engine::Report& report,
                                              const engine::Probe& probe);

// The probe's changes without those of the undisturbed run at the same time, and without those of
// the moves before it.
std::vector<const engine::Change*> changesByTouch(const engine::Report& report,
                                                  const engine::Probe& probe);

}  // namespace obby::importer
