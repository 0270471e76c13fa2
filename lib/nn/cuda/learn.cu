// CUDA entry points of the learning kernels.
#include "nn/cuda/cuda.h"
#include "nn/device/kernels.h"
#include "nn/device/learn_kernels.h"
#include "sim/cuda/launch.h"

namespace obby::nn::cuda {

const void* entry(Step step) {
#define OBBY_ENTRY(name, arguments, function) \
  if (step == Step::name) return sim::cuda::entry<arguments, function>();
  OBBY_NN_KERNELS(OBBY_ENTRY)
#undef OBBY_ENTRY
  return nullptr;
}

}  // namespace obby::nn::cuda
