// Launch form of the kernel of methods that learn while they search.
#include "sim/cuda/launch.h"
#include "solve/cuda/cuda.h"
#include "solve/learned/device_kernels.h"

namespace obby::solve::cuda {

const void* sightEntry() { return sim::cuda::entry<learned::SightArguments, learned::seePart>(); }

}  // namespace obby::solve::cuda
