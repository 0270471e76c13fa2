// What the CUDA build adds to the search.
#pragma once

#include "solve/resident/steps.h"

namespace obby::solve::cuda {

// Kernel::entry of their namesakes; null without CUDA.
const void* rolloutEntry(bool loose);
const void* residentEntry(ResidentStep step);
const void* sightEntry();

}  // namespace obby::solve::cuda
