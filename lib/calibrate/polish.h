// What comes after a search: from near to as near as the parameters go.
#pragma once

#include "calibrate/found.h"
#include "calibrate/work.h"

namespace obby::calibrate {

constexpr int kSlopeRounds = 12;  // of Gauss-Newton, at most

// By slopes, and by whole ticks where there are none; then over the leaps of what decides events,
// and of pairs of times. A stop ends it early, at what is found until then. Errors as of
// Level::compile.
Status polish(const Objective& objective, Found& found, const Work& work, Stretch stretch);

}  // namespace obby::calibrate
