#include "train/device/kernels.h"

#include "train/cuda/cuda.h"
#include "train/device/learn_kernels.h"
#include "train/device/play_kernels.h"

namespace obby::train {

const sim::Kernel& trainKernel(TrainStep step) {
#define OBBY_KERNEL(name, arguments, function) \
  sim::makeKernel<arguments, function>("train." #name, cuda::trainEntry(TrainStep::name)),
  static const sim::Kernel kernels[] = {OBBY_TRAIN_KERNELS(OBBY_KERNEL)};
#undef OBBY_KERNEL
  return kernels[size_t(step)];
}

}  // namespace obby::train
