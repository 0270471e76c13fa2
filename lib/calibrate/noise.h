// Estimates the measurement noise of recordings.
#pragma once

#include <span>

#include "calibrate/objective.h"

namespace obby::calibrate {

// A normal distribution's standard deviation, as a multiple of the median of its absolute values.
inline constexpr double kDeviationOfMedian = 1.4826;

// Returns the typical error of recorded positions in studs, or 0 without frames.
double noiseOf(std::span<const Take> takes);

}  // namespace obby::calibrate
