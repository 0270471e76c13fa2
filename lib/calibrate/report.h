// Calibration results as text.
#pragma once

#include <string>
#include <vector>

#include "calibrate/fit.h"

namespace obby::calibrate {

// Error of a recording's complete playback with the fitted parameters.
struct Outcome {
  std::string name;
  bool heldOut = false;  // not used by the fit
  Path path;
  Miss miss;
};

// Joins the printed ends of a range, or returns one if both print the same.
std::string rangeText(const std::string& low, const std::string& high);

// Returns a note that the fit was interrupted, or an empty text.
std::string interruptionOf(const Fit& fit);

// Returns the mean error of the held-out recordings, or of all if none is held out.
double meanMiss(const std::vector<Outcome>& outcomes);

// `why`: reasons why the fit is not within the tolerance (reasonsOf() in shortfall.h), or an empty
// list.
std::string textOf(const Fit& fit, const std::vector<Outcome>& outcomes, double tolerance,
                   const std::vector<std::string>& why);

}  // namespace obby::calibrate
