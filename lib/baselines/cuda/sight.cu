// CUDA entry point of the kernel of methods that learn while they search.
#include "baselines/cuda/cuda.h"
#include "baselines/device_kernels.h"
#include "sim/cuda/launch.h"

namespace obby::baselines::cuda {

const void* sightEntry() { return sim::cuda::entry<SightArguments, seePart>(); }

}  // namespace obby::baselines::cuda
