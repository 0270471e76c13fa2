// Launch form of the rollout kernel.
#include "solve/cuda/cuda.h"
#include "solve/rollout_kernel.h"

namespace obby::solve::cuda {
namespace {

__global__ void rollout(const __grid_constant__ RolloutArguments arguments, uint32_t count) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) exploreOne(arguments, i);
}

}  // namespace

const void* rolloutEntry() { return reinterpret_cast<const void*>(rollout); }

}  // namespace obby::solve::cuda
