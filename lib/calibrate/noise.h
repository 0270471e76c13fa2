// How much of what a recording shows is its recorder's.
#pragma once

#include <span>

#include "calibrate/objective.h"

namespace obby::calibrate {

// A normal distribution's standard deviation, as a multiple of the median of its absolute values.
inline constexpr double kDeviationOfMedian = 1.4826;

// Studs by which recorded positions are off by themselves, in the middle; 0 without frames.
double noiseOf(std::span<const Take> takes);

}  // namespace obby::calibrate
