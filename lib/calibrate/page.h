// What a calibration found, as a page to look at: parameters with their intervals, and for each
// recording its way beside the simulator's. One file without scripts, readable offline, on light
// and on dark.
#pragma once

#include <string>
#include <vector>

#include "calibrate/report.h"

namespace obby::calibrate {

// `why`: as textOf() in report.h has it.
std::string pageOf(const Fit& fit, const std::vector<Outcome>& outcomes, double tolerance,
                   const std::vector<std::string>& why);

}  // namespace obby::calibrate
