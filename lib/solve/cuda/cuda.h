// What the CUDA build adds to the search.
#pragma once

namespace obby::solve::cuda {

const void* rolloutEntry(bool loose);  // Kernel::entry of rolloutKernel; null without CUDA

}  // namespace obby::solve::cuda
