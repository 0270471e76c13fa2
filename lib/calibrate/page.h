// Calibration results as an HTML page: parameters with their intervals, and each recorded
// trajectory next to the simulated one. It is one file without scripts, readable offline in light
// and dark themes.
#pragma once

#include <string>
#include <vector>

#include "calibrate/report.h"

namespace obby::calibrate {

// `why`: as for textOf() in report.h.
std::string pageOf(const Fit& fit, const std::vector<Outcome>& outcomes, double tolerance,
                   const std::vector<std::string>& why);

}  // namespace obby::calibrate
