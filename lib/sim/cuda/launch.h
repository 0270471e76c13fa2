// Wraps a kernel function for launches on a GPU. For .cu files only.
#pragma once

#include <cstdint>

namespace obby::sim::cuda {

template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
__global__ void launched(const __grid_constant__ Arguments arguments, uint32_t count) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) kFunction(arguments, i);
}

// Returns the Kernel::entry of a kernel function.
template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
const void* entry() {
  return reinterpret_cast<const void*>(launched<Arguments, kFunction>);
}

}  // namespace obby::sim::cuda
