// Launch forms of the kernels that simulate worlds.
#include "sim/cuda/launch.h"
#include "train/cuda/cuda.h"
#include "train/device/kernels.h"
#include "train/device/play_kernels.h"

namespace obby::train::cuda {

const void* playEntry(TrainStep step) {
#define OBBY_ENTRY(name, arguments, function) \
  if (step == TrainStep::name) return sim::cuda::entry<arguments, function>();
  OBBY_PLAY_KERNELS(OBBY_ENTRY)
#undef OBBY_ENTRY
  return nullptr;
}

}  // namespace obby::train::cuda
