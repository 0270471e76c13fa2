// The functions of cuda.h in a build without CUDA.
#include "sim/cuda/cuda.h"

namespace obby::sim::cuda {

Result<std::unique_ptr<Device>> openDevice(uint32_t) {
  return makeError("this build has no CUDA support", "build it with nvcc: cmake --preset cuda");
}

const void* stepEntry(StepKind) { return nullptr; }
const void* probeEntry() { return nullptr; }

}  // namespace obby::sim::cuda
