// The entry point that the CUDA build adds to the methods that learn.
#pragma once

namespace obby::baselines::cuda {

// Returns Kernel::entry of the kernel of the same name; null without CUDA.
const void* sightEntry();

}  // namespace obby::baselines::cuda
