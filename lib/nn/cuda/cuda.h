// What the CUDA build adds to networks.
#pragma once

namespace obby::nn {
enum class Step;
}

namespace obby::nn::cuda {

// Kernel::entry of its namesake; null without CUDA.
const void* entry(Step step);

}  // namespace obby::nn::cuda
