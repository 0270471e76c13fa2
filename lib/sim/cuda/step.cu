// The GPU form of the step kernel.
#include "sim/step_kernel.h"

namespace obby::sim::cuda {
namespace {

template <StepKind kKind>
__global__ void step(const __grid_constant__ StepArguments arguments, uint32_t count) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) stepWorld<kKind>(arguments, i);
}

}  // namespace

const void* stepEntry(StepKind kind) {
  switch (kind) {
    case StepKind::oneLevel: return reinterpret_cast<const void*>(step<StepKind::oneLevel>);
    case StepKind::manyLevels: return reinterpret_cast<const void*>(step<StepKind::manyLevels>);
    case StepKind::bodies: break;
  }
  return reinterpret_cast<const void*>(step<StepKind::bodies>);
}

}  // namespace obby::sim::cuda
