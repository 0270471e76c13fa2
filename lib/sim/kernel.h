// A kernel: a function of an argument struct and an index, and the two ways to run it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace obby::sim {

// The kernels that step worlds: three, since code that is never run costs a GPU registers and stack
// all the same.
enum class StepKind {
  oneLevel,    // without loose bodies
  manyLevels,  // without loose bodies
  loose        // any course
};

struct Kernel {
  const char* name;
  // On the CPU, for one index.
  void (*body)(const void* arguments, uint32_t index);
  // For cudaLaunchKernel: __global__ void(Arguments, uint32_t count); null without CUDA.
  const void* entry;
  size_t argumentBytes;
};

// Kernel::body of a function that takes its arguments by their type.
template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
void kernelBody(const void* arguments, uint32_t index) {
  kFunction(*static_cast<const Arguments*>(arguments), index);
}

// A kernel by its function; `entry`: see Kernel.
template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
Kernel makeKernel(const char* name, const void* entry) {
  static_assert(sizeof(Arguments) <= 4096, "a kernel's arguments on a GPU");
  return {name, kernelBody<Arguments, kFunction>, entry, sizeof(Arguments)};
}

}  // namespace obby::sim
