// What a calibration found, as a text for people.
#pragma once

#include <string>
#include <vector>

#include "calibrate/fit.h"

namespace obby::calibrate {

// How far off a recording is, played to its end with the fitted parameters.
struct Outcome {
  std::string name;
  bool heldOut = false;  // the fit has not seen it
  Path path;
  Miss miss;
};

// That a fit was interrupted, and what this means; nothing of one that was not.
std::string interruptionOf(const Fit& fit);

// Mean over those that are held out, or over all where none is.
double meanMiss(const std::vector<Outcome>& outcomes);

// `why`: it is not nearer, a reason each (reasonsOf() in shortfall.h); none within the tolerance.
std::string textOf(const Fit& fit, const std::vector<Outcome>& outcomes, double tolerance,
                   const std::vector<std::string>& why);

}  // namespace obby::calibrate
