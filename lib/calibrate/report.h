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

// Mean over those that are held out, or over all where none is.
double meanMiss(const std::vector<Outcome>& outcomes);

std::string textOf(const Fit& fit, const std::vector<Outcome>& outcomes, double tolerance);

}  // namespace obby::calibrate
