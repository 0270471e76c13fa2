// What the CUDA build adds, behind functions that a build without CUDA has, too (absent.cpp).
#pragma once

#include <memory>

#include "base/result.h"
#include "sim/device.h"
#include "sim/kernel.h"

namespace obby::sim::cuda {

// GPU `which`, counted round where there are fewer. Without CUDA in this build, a driver or a GPU
// that runs kernels of this build: an error that says which.
Result<std::unique_ptr<Device>> openDevice(uint32_t which);

const void* stepEntry(StepKind kind);  // Kernel::entry of stepKernel
const void* probeEntry();              // of a kernel without arguments that does nothing

}  // namespace obby::sim::cuda
