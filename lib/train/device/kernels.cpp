#include "train/device/kernels.h"

#include "train/cuda/cuda.h"
#include "train/device/learn_kernels.h"
#include "train/device/play_kernels.h"

namespace obby::train {

namespace {

template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
sim::Kernel kernel(const char* name, TrainStep step) {
  static_assert(sizeof(Arguments) <= 4096, "a kernel's arguments on a GPU");
  return {name, sim::kernelBody<Arguments, kFunction>, cuda::trainEntry(step), sizeof(Arguments)};
}

}  // namespace

const sim::Kernel& trainKernel(TrainStep step) {
#define OBBY_KERNEL(name, arguments, function) \
  kernel<arguments, function>("train." #name, TrainStep::name),
  static const sim::Kernel kernels[] = {OBBY_TRAIN_KERNELS(OBBY_KERNEL)};
#undef OBBY_KERNEL
  return kernels[size_t(step)];
}

}  // namespace obby::train
