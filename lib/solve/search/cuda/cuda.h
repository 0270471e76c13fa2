// Entry points that the CUDA build adds to the search.
#pragma once

namespace obby::solve {
enum class ResidentStep;
}  // namespace obby::solve

namespace obby::solve::cuda {

// Return Kernel::entry of the kernels of the same names; null without CUDA.
const void* rolloutEntry(bool loose);
const void* residentEntry(ResidentStep step);

}  // namespace obby::solve::cuda
