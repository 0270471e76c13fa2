// Settings that end trajectories early, for methods that learn while they search. Within a few
// rounds players return to visited cells, and then the learned policy decides their actions.
#pragma once

#include "baselines/cflge.h"
#include "baselines/pbge.h"

namespace obby::support {

inline baselines::PbgeSettings hasty(baselines::PbgeSettings settings) {
  settings.patience = 10;  // shorter than a jump
  return settings;
}

inline baselines::CflgeSettings hasty(baselines::CflgeSettings settings) {
  settings.explore = settings.patience = 12;
  settings.begin = 256;
  settings.refresh = 1000;
  settings.moduleSteps = 0.02f;  // few, since learning would take most of the time
  settings.policySteps = 1.0f / 128;
  return settings;
}

}  // namespace obby::support
