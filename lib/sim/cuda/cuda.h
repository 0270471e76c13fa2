// Functions of the CUDA build. A build without CUDA has them, too (absent.cpp).
#pragma once

#include <memory>

#include "base/result.h"
#include "sim/device.h"
#include "sim/kernel.h"

namespace obby::sim::cuda {

// Opens GPU `which`, modulo the number of GPUs. Errors: a build without CUDA, a missing driver, or
// a GPU that cannot run this build's kernels.
Result<std::unique_ptr<Device>> openDevice(uint32_t which);

const void* stepEntry(StepKind kind);  // Kernel::entry of stepKernel
const void* probeEntry();              // entry of a kernel that has no arguments and does nothing

}  // namespace obby::sim::cuda
