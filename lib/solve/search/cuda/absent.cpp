// Entry points in a build without CUDA.
#include "solve/search/cuda/cuda.h"

namespace obby::solve::cuda {

const void* rolloutEntry(bool) { return nullptr; }
const void* residentEntry(ResidentStep) { return nullptr; }

}  // namespace obby::solve::cuda
