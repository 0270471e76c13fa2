// How much of what a recording shows is its recorder's.
#pragma once

#include <span>

#include "calibrate/objective.h"

namespace obby::calibrate {

// Studs by which recorded positions are off by themselves, in the middle; 0 without frames.
double noiseOf(std::span<const Take> takes);

}  // namespace obby::calibrate
