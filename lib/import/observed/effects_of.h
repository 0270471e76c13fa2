// Finds what one probe changed: the difference between it and the undisturbed run.
#pragma once

#include "import/observed/probe_effects.h"

namespace obby::importer {

ProbeEffects effectsOf(const engine::Report& report, const engine::Probe& probe);

}  // namespace obby::importer
