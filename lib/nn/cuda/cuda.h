// Entry points of the CUDA kernels for networks.
#pragma once

namespace obby::nn {
enum class Step;
}

namespace obby::nn::cuda {

// Returns Kernel::entry of that step's kernel; null without CUDA.
const void* entry(Step step);

}  // namespace obby::nn::cuda
