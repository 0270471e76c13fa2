// Entry points of the CUDA kernels for training.
#pragma once

namespace obby::train {
enum class TrainStep;
}

namespace obby::train::cuda {

// Returns Kernel::entry of that step's kernel; null without CUDA.
const void* trainEntry(TrainStep step);

// Returns the entries in play.cu, which takes long to compile as it simulates worlds.
const void* playEntry(TrainStep step);

}  // namespace obby::train::cuda
