// A build without CUDA.
#include "train/cuda/cuda.h"

namespace obby::train::cuda {

const void* trainEntry(TrainStep) { return nullptr; }
const void* playEntry(TrainStep) { return nullptr; }

}  // namespace obby::train::cuda
