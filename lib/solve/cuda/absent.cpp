// A build without CUDA.
#include "solve/cuda/cuda.h"

namespace obby::solve::cuda {

const void* rolloutEntry(bool) { return nullptr; }

}  // namespace obby::solve::cuda
