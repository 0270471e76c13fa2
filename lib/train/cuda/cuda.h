// What the CUDA build adds to learning.
#pragma once

namespace obby::train {
enum class TrainStep;
}

namespace obby::train::cuda {

// Kernel::entry of its namesake; null without CUDA.
const void* trainEntry(TrainStep step);

// The part of it that play.cu knows: kernels that simulate worlds take long to compile.
const void* playEntry(TrainStep step);

}  // namespace obby::train::cuda
