// Local refinement after a search.
#pragma once

#include "calibrate/found.h"
#include "calibrate/work.h"

namespace obby::calibrate {

constexpr int kGradientRounds = 12;  // max rounds of Gauss-Newton

// Takes gradient steps, then searches tick-valued parameters, then discontinuous ones and pairs of
// tick counts. After a stop, `found` is the best result so far. Errors: those of Level::compile.
Status polish(const Objective& objective, Found& found, const Work& work, Stretch stretch);

}  // namespace obby::calibrate
