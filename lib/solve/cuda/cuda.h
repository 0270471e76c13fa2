// Entry points that the CUDA build adds to the search.
#pragma once

#include "solve/learned/device_steps.h"
#include "solve/resident/steps.h"

namespace obby::solve::cuda {

// Return Kernel::entry of the kernels of the same names; null without CUDA.
const void* rolloutEntry(bool loose);
const void* residentEntry(ResidentStep step);
const void* learnedEntry(learned::LearnedStep step);

}  // namespace obby::solve::cuda
