// Entry points in a build without CUDA.
#include "solve/cuda/cuda.h"

namespace obby::solve::cuda {

const void* rolloutEntry(bool) { return nullptr; }
const void* residentEntry(ResidentStep) { return nullptr; }
const void* learnedEntry(learned::LearnedStep) { return nullptr; }

}  // namespace obby::solve::cuda
