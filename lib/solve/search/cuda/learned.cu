// CUDA entry points of the kernels of methods that learn while they search.
#include "sim/cuda/launch.h"
#include "solve/learned/device_kernels.h"
#include "solve/search/cuda/cuda.h"

namespace obby::solve::cuda {

const void* sightEntry() { return sim::cuda::entry<learned::SightArguments, learned::seePart>(); }

}  // namespace obby::solve::cuda
