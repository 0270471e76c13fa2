// The entry point in a build without CUDA.
#include "baselines/cuda/cuda.h"

namespace obby::baselines::cuda {

const void* sightEntry() { return nullptr; }

}  // namespace obby::baselines::cuda
