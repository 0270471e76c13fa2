// Launch form of the step kernel.
#include "sim/step_kernel.h"

namespace obby::sim::cuda {
namespace {

template <bool kOneLevel>
__global__ void step(const __grid_constant__ StepArguments arguments, uint32_t count) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) stepWorld<kOneLevel>(arguments, i);
}

}  // namespace

const void* stepEntry(bool oneLevel) {
  return oneLevel ? reinterpret_cast<const void*>(step<true>)
                  : reinterpret_cast<const void*>(step<false>);
}

}  // namespace obby::sim::cuda
