// The entry point in a build without CUDA.
#include "nn/cuda/cuda.h"

namespace obby::nn::cuda {

const void* entry(Step) { return nullptr; }

}  // namespace obby::nn::cuda
