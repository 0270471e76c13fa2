// Settings of methods that learn while they search under which playthroughs end soon: within a few
// rounds players return to where others have been, and what they learned decides what they play.
#pragma once

#include "solve/learned/cflge.h"
#include "solve/learned/pbge.h"

namespace obby::support {

inline solve::learned::PbgeSettings hasty(solve::learned::PbgeSettings settings) {
  settings.patience = 10;  // a jump is longer
  return settings;
}

inline solve::learned::CflgeSettings hasty(solve::learned::CflgeSettings settings) {
  settings.explore = settings.patience = 12;
  settings.begin = 256;
  settings.refresh = 1000;
  settings.moduleSteps = 0.02f;  // steps of learning are most of the time
  settings.policySteps = 1.0f / 128;
  return settings;
}

}  // namespace obby::support
