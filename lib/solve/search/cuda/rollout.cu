// CUDA entry point of the rollout kernel.
#include "solve/search/cuda/cuda.h"
#include "solve/search/rollouts/rollout_kernel.h"

namespace obby::solve::cuda {
namespace {

template <bool kDynamic>
__global__ void rollout(const __grid_constant__ RolloutArguments arguments, uint32_t count) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) exploreOne<kDynamic>(arguments, i);
}

}  // namespace

const void* rolloutEntry(bool bodies) {
  return bodies ? reinterpret_cast<const void*>(rollout<true>)
                : reinterpret_cast<const void*>(rollout<false>);
}

}  // namespace obby::solve::cuda
