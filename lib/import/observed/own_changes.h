// The changes in a probe that are its own: the rest came by itself or with any walk.
#pragma once

#include <vector>

#include "engine/report.h"

namespace obby::importer {

// Where scripts read MoveDirection, whoever comes to a part walks: what they do about any walk.
// Null: nothing.
const engine::Probe* walkBefore(const engine::Report& report, const engine::Probe& probe);

// The probe's changes without those of the undisturbed run at the same time, and without those of
// any walk.
std::vector<const engine::Change*> changesByTouch(const engine::Report& report,
                                                  const engine::Probe& probe);

}  // namespace obby::importer
